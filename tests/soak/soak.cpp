// SPDX-License-Identifier: MIT
// soak BACKEND ROBOTS DURATION_S OUT: one long run of the paper's rules into a folder, with its invariants checked at every tick.
// Prints a line of CSV for each 1000 s of the ecology's clock: memory and wall time, which must not grow. See scripts/soak.
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <soak/invariants.hpp>
#include <string>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/rules/paper.hpp>

namespace {

using namespace trophic;

/// Memory that the program holds, in MB.
double resident_mb() {
  std::ifstream statm{"/proc/self/statm"};
  double pages = 0.0;
  statm >> pages >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

struct Report {
  double every_s = 1000.0;
  double next_s = every_s;
  double wall_s = 0.0;
  observe::Stopwatch watch = {};

  void on_tick(const View& view) {
    if (view.time_s < next_s) return;
    next_s += every_s;
    const double now_s = watch.elapsed_s();
    std::cout << view.time_s << ',' << resident_mb() << ',' << now_s - wall_s << std::endl;
    wall_s = now_s;
  }
};

template <class Backend>
void soak(std::size_t robots, double duration_s, const std::string& out) {
  Experiment<rules::Paper, Backend> numbers;
  numbers.ecology.robots = robots;
  numbers.rules.community.predators = robots * 14 / 30;
  if constexpr (requires { numbers.backend.threads; }) numbers.backend.threads = 2;
  // As crowded as the table's thirty.
  const double larger = std::sqrt(static_cast<double>(robots) / static_cast<double>(rules::Paper::ecology().robots));
  Habitat habitat = load_habitat(numbers.ecology);
  habitat.arena.half_side_m *= larger;
  habitat.arena.extent_m *= larger;
  test::Invariants invariants{numbers.rules.floor.floor};
  Report report;
  observe::RunFolder folder{out, {}, {.replay_hz = 0.0, .agents_every_ticks = 1000}};
  Ecology<rules::Paper, Backend> ecology{numbers, habitat};
  std::cout << "time_s,resident_mb,wall_s" << std::endl;
  ecology.run_until(duration_s, folder, invariants, report);
  std::cerr << invariants.ticks() << " ticks of " << robots << " robots, " << invariants.deaths()
            << " deaths: all invariants held\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5) throw std::invalid_argument{"soak BACKEND ROBOTS DURATION_S OUT"};
  const std::string backend = argv[1];
  const auto run = backend == "mujoco" ? &soak<backend::Mujoco> : &soak<backend::Kinematic>;
  run(std::stoul(argv[2]), std::stod(argv[3]), argv[4]);
} catch (const std::exception& error) {
  std::cerr << "soak: " << error.what() << "\n";
  return 1;
}
