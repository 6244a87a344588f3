// SPDX-License-Identifier: MIT
// soak BACKEND ROBOTS DURATION_S OUT [rest]: one long run of the paper's rules into a folder, with its invariants checked at
// every tick; with rest, of robots that only lie there. OUT.csv has a line for each 100 s of the ecology's clock: memory and
// wall time, which must not grow. A run that was stopped goes on from its last checkpoint, with exit code 3 until it is done. See
// scripts/soak.
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <soak/invariants.hpp>
#include <soak/resting.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <support/resident_bytes.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/checkpoint/go_on.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/rules/paper.hpp>

namespace {

using namespace trophic;

/// A line of CSV for each 100 s, in a file that is gone on with where the run is.
class Report {
 public:
  explicit Report(const std::string& path, bool goes_on) : csv_{path, goes_on ? std::ios::app : std::ios::trunc} {
    if (!goes_on) csv_ << "time_s,resident_mb,wall_s" << std::endl;
  }

  void on_start(const observe::RunDescription&, const View&) { watch_ = {}; }
  void on_tick(const View& view) {
    if (view.time_s < next_s_) return;
    next_s_ += every_s;
    csv_ << view.time_s << ',' << test::resident_bytes() / 1e6 << ',' << watch_.elapsed_s() << std::endl;
    watch_ = {};
  }

  static constexpr std::string_view section = "report";  ///< of a checkpoint
  void persist(Archive& archive) { archive(next_s_); }

 private:
  static constexpr double every_s = 100.0;
  double next_s_ = every_s;
  observe::Stopwatch watch_ = {};
  std::ofstream csv_;
};

struct Wanted {
  std::size_t robots = 0;
  double duration_s = 0.0;
  std::filesystem::path out;
  bool at_rest = false;
};

template <class Backend>
bool soak(const Wanted& wanted) {
  if (wanted.at_rest && wanted.duration_s <= test::Resting::settles_s) {
    throw std::invalid_argument{"DURATION_S: must be > " + std::to_string(test::Resting::settles_s) +
                                ", until robots are at rest"};
  }
  Experiment<rules::Paper, Backend> numbers;
  numbers.ecology.robots = wanted.robots;
  numbers.rules.community.predators = wanted.robots * 14 / 30;
  if constexpr (requires { numbers.backend.threads; }) numbers.backend.threads = 2;
  // As crowded as the table's thirty.
  const double larger = std::sqrt(static_cast<double>(wanted.robots) / static_cast<double>(rules::Paper::ecology().robots));
  Habitat habitat = load_habitat(numbers.ecology);
  habitat.arena.half_side_m *= larger;
  habitat.arena.extent_m *= larger;
  if (wanted.at_rest) habitat = test::at_rest(habitat);

  Ecology<rules::Paper, Backend> ecology{numbers, habitat};
  const checkpoint::Standing standing = checkpoint::standing_in(wanted.out, ecology.describe(wanted.duration_s));
  if (standing.complete) return true;
  if (!standing.remark.empty()) std::cerr << wanted.out.string() << " " << standing.remark << "\n";
  observe::StopOnSignal stop;
  observe::RunFolder folder{wanted.out, {}, {.replay_hz = 0.0, .agents_every_ticks = 1000}, standing.opening()};
  Report report{wanted.out.string() + ".csv", standing.from.has_value()};
  test::Invariants invariants{numbers.rules.floor.floor};
  test::Resting resting;
  const auto run = [&](auto&... more) {
    checkpoint::run_kept(ecology, wanted.duration_s, wanted.out, {.every_s = 100.0}, standing.from, folder, invariants, report,
                         stop, more...);
  };
  if (wanted.at_rest) {
    run(resting);
    std::cerr << "at rest: gained at most " << resting.gain_J() << " J, moved at most " << resting.drift_m() << " m\n";
  } else {
    run();
  }
  std::cerr << invariants.ticks() << " ticks of " << wanted.robots << " robots, " << invariants.deaths()
            << " deaths: all invariants held\n";
  return ecology.time_s() >= wanted.duration_s;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5 && argc != 6) throw std::invalid_argument{"soak BACKEND ROBOTS DURATION_S OUT [rest]"};
  const std::string backend = argv[1];
  const auto run = backend == "mujoco" ? &soak<backend::Mujoco> : &soak<backend::Kinematic>;
  const bool done = run({.robots = std::stoul(argv[2]), .duration_s = std::stod(argv[3]), .out = argv[4], .at_rest = argc == 6});
  return done ? 0 : 3;
} catch (const std::exception& error) {
  std::cerr << "soak: " << error.what() << "\n";
  return 1;
}
