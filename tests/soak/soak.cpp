// SPDX-License-Identifier: MIT
// One long run of the paper's rules into a folder, with its invariants checked at every tick; with --rest, of robots that only
// lie there. OUT.csv has a row for each 100 s of the ecology's clock: memory that the program held, the least that it had asked
// for at a tick of these 100 s, wall time and processor time; growth.py tests whether they grew. Exit code 0: all invariants
// held; 1: otherwise; 3: it was stopped, and resumes from its last checkpoint when run again. See scripts/soak.
#include <CLI/CLI.hpp>
#include <ctime>
#include <iostream>
#include <soak/invariants.hpp>
#include <soak/resting.hpp>
#include <support/memory.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/run/checkpoint/resume.hpp>

namespace {

using namespace trophic;

/// Processor time that the program has taken, seconds.
double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The program's use of memory and time, a row of CSV for each 100 s.
class Report {
 public:
  Report(const std::string& path, Opening opening) : csv_{path, opening} {
    if (opening == Opening::created) csv_.append("time_s,resident_mb,least_allocated_mb,wall_s,processor_s\n");
  }

  void on_start(const observe::RunDescription&, const View&) { begin(); }
  void on_tick(const View& view) {
    least_allocated_bytes_ = std::min(least_allocated_bytes_, test::allocated_bytes());
    if (view.time_s < next_s_) return;
    next_s_ += every_s;
    std::string row = number_text(view.time_s);
    for (const double number :
         {test::resident_bytes() / 1e6, least_allocated_bytes_ / 1e6, watch_.elapsed_s(), processor_s() - processor_from_s_}) {
      row += ',' + number_text(number);
    }
    csv_.append(row + '\n');
    begin();
  }

  static constexpr std::string_view section = "report";  ///< of a checkpoint
  void persist(Archive& archive) {
    archive(next_s_);
    csv_.persist(archive);
  }

 private:
  static constexpr double every_s = 100.0;

  void begin() {
    watch_ = {};
    processor_from_s_ = processor_s();
    least_allocated_bytes_ = std::numeric_limits<double>::infinity();
  }

  double next_s_ = every_s;
  observe::Stopwatch watch_ = {};
  double processor_from_s_ = 0.0;
  double least_allocated_bytes_ = 0.0;
  GrowingFile csv_;
};

struct Wanted {
  std::size_t robots = 0;
  double duration_s = 0.0;
  std::filesystem::path out;
  bool at_rest = false;
  double timestep_s = rules::Paper::physics().timestep_s;
  double room = 1.0;
  std::string gait;
  bool shadow = false;
};

Experiment<rules::Paper> numbers_of(const Wanted& wanted) {
  Experiment<rules::Paper> numbers;
  numbers.ecology.robots = wanted.robots;
  numbers.ecology.gait = wanted.gait;
  numbers.physics.timestep_s = wanted.timestep_s;
  numbers.rules.community.predators = wanted.robots * 14 / 30;
  numbers.null = wanted.shadow ? Null::shadow : Null::none;
  return numbers;
}

bool run(const Experiment<rules::Paper>& numbers, const BackendChoice& backend, const Wanted& wanted) {
  const double larger =
      std::sqrt(wanted.room * static_cast<double>(wanted.robots) / static_cast<double>(rules::Paper::ecology().robots));
  Habitat habitat = load_habitat(numbers.ecology);
  habitat.arena.half_side_m *= larger;
  habitat.arena.extent_m *= larger;
  if (wanted.at_rest) habitat = test::at_rest(habitat);

  Ecology<rules::Paper> ecology{numbers, backend, habitat};
  const checkpoint::RunState run_state = checkpoint::run_state_in(wanted.out, ecology.describe(wanted.duration_s));
  if (run_state.complete) return true;
  if (!run_state.remark.empty()) std::cerr << wanted.out.string() << " " << run_state.remark << "\n";
  replicates::StopOnSignal stop;
  io::RunFolder folder{wanted.out, {}, {.replay_hz = 0.0, .agents_every_ticks = 1000}, run_state.opening()};
  Report report{wanted.out.string() + ".csv", run_state.opening()};
  test::Invariants invariants{numbers.rules.floor.floor};
  test::Resting resting;
  const auto keep_running = [&](auto&... more) {
    checkpoint::run_with_checkpoints(ecology, wanted.duration_s, wanted.out, {.every_s = 100.0}, run_state.from, folder,
                                     invariants, report, stop, more...);
  };
  if (wanted.at_rest) {
    keep_running(resting);
    std::cerr << "at rest: gained at most " << resting.gain_J() << " J, moved at most " << resting.drift_m() << " m\n";
  } else {
    keep_running();
  }
  std::cerr << invariants.ticks() << " ticks of " << wanted.robots << " robots, " << invariants.deaths()
            << " deaths: all invariants held\n";
  return ecology.time_s() >= wanted.duration_s;
}

template <class Backend>
bool soak(const Wanted& wanted) {
  if (wanted.at_rest && wanted.duration_s <= test::Resting::settles_s) {
    throw std::invalid_argument{"DURATION_S: must be > " + std::to_string(test::Resting::settles_s) +
                                ", until robots are at rest"};
  }
  BackendChoice backend{typename Backend::Params{}};
  if (std::size_t* threads = backend.threads()) *threads = 2;
  return run(numbers_of(wanted), backend, wanted);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"One long run, with its invariants checked at every tick."};
  Wanted wanted;
  std::string backend;
  app.add_option("BACKEND", backend)->required()->check(CLI::IsMember({"kinematic", "mujoco"}));
  app.add_option("ROBOTS", wanted.robots)->required()->check(CLI::PositiveNumber);
  app.add_option("DURATION_S", wanted.duration_s)->required()->check(CLI::PositiveNumber);
  app.add_option("OUT", wanted.out)->required();
  app.add_flag("--rest", wanted.at_rest, "robots that only lie there");
  app.add_option("--timestep-s", wanted.timestep_s, "of MuJoCo's steps")->capture_default_str();
  app.add_option("--room", wanted.room, "floor for each robot, times that of the table's thirty")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--gait", wanted.gait, "name or path of a gait file (the spider's own)");
  app.add_flag("--shadow", wanted.shadow, "no inheritance: what evolves may come to crowd, and crowds take memory");
  CLI11_PARSE(app, argc, argv);
  const bool done = backend == "mujoco" ? soak<backend::Mujoco>(wanted) : soak<backend::Kinematic>(wanted);
  return done ? 0 : 3;
} catch (const std::exception& error) {
  std::cerr << "soak: " << error.what() << "\n";
  return 1;
}
