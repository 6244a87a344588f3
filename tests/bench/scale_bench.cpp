// SPDX-License-Identifier: MIT
// How a tick of a large ecology grows with the number of robots, and what share of it each part takes: perception and brains,
// catches, births, hunger, logs, and the bodies, on the kinematic backend and on MuJoCo. How a tick of a living world grows.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <chrono>
#include <ctime>
#include <support/memory.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/torus.hpp>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/perception/sensors/rays.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/with.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/worlds/pond.hpp>
#include <trophic/worlds/wolf_sheep.hpp>

namespace {

using namespace trophic;

/// What a tick consists of, in the order in which it first comes.
enum class Part { bodies, activation, catches, ageing, hunger, perception, births, logs };
constexpr std::array<const char*, 8> part_names{"bodies_%", "activation_%", "catches_%", "ageing_%",
                                                "hunger_%", "perception_%", "births_%",  "logs_%"};

/// Where the wall time goes: what passes between two calls of `enter` belongs to the part that the first one named.
class Clock {
 public:
  static void enter(Part part) {
    const auto now = std::chrono::steady_clock::now();
    spent_s.at(static_cast<std::size_t>(at)) += std::chrono::duration<double>(now - since).count();
    since = now;
    at = part;
  }
  static void reset() {
    spent_s = {};
    since = std::chrono::steady_clock::now();
    at = Part::bodies;
  }

  static inline Part at = Part::bodies;
  static inline std::array<double, part_names.size()> spent_s{};

 private:
  static inline std::chrono::steady_clock::time_point since;
};

// Rules that the ecology asks once a tick tell the clock that their part begins.
struct TimedCapture : death::capture::CatchWithinReach {
  [[nodiscard]] std::vector<death::Capture> captures(const View& view, Rng& rng) const {
    Clock::enter(Part::catches);
    return CatchWithinReach::captures(view, rng);
  }
};
struct TimedSenescence : death::senescence::NoSenescence {
  [[nodiscard]] bool dies(const Individual& individual, const View& view, Rng& rng) const {
    if (Clock::at != Part::ageing) Clock::enter(Part::ageing);
    return NoSenescence::dies(individual, view, rng);
  }
};
struct TimedSchedule : death::starvation::interval::DelayedCrowdingInterval {
  [[nodiscard]] bool due(const death::starvation::StarvationClock& clock, const View& view) const {
    Clock::enter(Part::hunger);
    return DelayedCrowdingInterval::due(clock, view);
  }
};
struct TimedTagRatio : perception::sensors::TagRatioOfAll {
  [[nodiscard]] std::array<double, size> sense(const View& view) const {
    Clock::enter(Part::perception);
    return TagRatioOfAll::sense(view);
  }
};
using TimedSensors =
    perception::sensors::List<perception::sensors::SideOfAdversary, perception::sensors::DistanceOverTerrain, TimedTagRatio>;
using TimedPaper = with_sensors<
    with_starvation_interval<with_senescence<with_capture<rules::Paper, TimedCapture>, TimedSenescence>, TimedSchedule>,
    TimedSensors>;

/// A backend that tells the clock when the bodies have moved: the ecology looks at them from the first to the last.
template <class Base>
struct Timed : Base {
  struct Params {  // none: the base has its own
    using Backend = Timed;
  };
  Timed(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics, const Params&)
      : Base{robot, arena, starts, physics, {}} {}
  [[nodiscard]] Pose pose(std::size_t robot) const {
    if (robot == 0) Clock::enter(Part::activation);
    return Base::pose(robot);
  }
};

/// The observers before and after the logs.
struct BeforeLogs {
  static inline Part during = Part::bodies;
  void on_event(const observe::Event&, const View&) {
    if (Clock::at != Part::births) during = Clock::at;
    Clock::enter(Part::logs);
  }
  void on_tick(const View&) { Clock::enter(Part::logs); }
};
struct AfterLogs {
  void on_event(const observe::Event& event, const View&) {
    Clock::enter(event.kind == observe::EventKind::death ? Part::births : BeforeLogs::during);
  }
  void on_tick(const View&) { Clock::enter(Part::bodies); }
};

/// Processor time of this process, seconds: other programs on the machine do not count.
double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Starts the measurement once so many ticks are over.
class WarmUp {
 public:
  explicit WarmUp(std::int64_t ticks) : ticks_{ticks} {}
  void on_tick(const View& view) {
    if (view.tick != ticks_) return;
    from_s_ = processor_s();
    Clock::reset();
  }
  [[nodiscard]] double elapsed_s() const { return processor_s() - from_s_; }

 private:
  std::int64_t ticks_;
  double from_s_ = 0.0;
};

/// Ticks of the paper's rules at the paper's density and share of predators, with all tables of a run's folder and no recording.
/// Those of the warm-up are not measured: at the start all robots show the same tag. agents.csv has every tick or every tenth.
/// The time reported is the processor's for one tick; shares are of wall time.
template <class Backend>
void tick(benchmark::State& state, std::int64_t warm_up, std::int64_t ticks) {
  Experiment<TimedPaper> numbers;
  numbers.ecology.robots = static_cast<std::size_t>(state.range(0));
  numbers.ecology.arena = "walled_by_density";
  numbers.rules.community.predators = numbers.ecology.robots * 14 / 30;

  ::malloc_trim(0);
  const double before_bytes = test::resident_bytes();
  Ecology<TimedPaper> ecology{numbers, typename Timed<Backend>::Params{}};
  const trophic::test::TemporaryFolder folder;
  io::RunFolder files{folder.path() / "run", {}, {.replay_hz = 0.0, .agents_every_ticks = state.range(1)}};
  BeforeLogs before;
  AfterLogs after;
  WarmUp warm{warm_up};
  for (auto _ : state) {
    ecology.run_until(static_cast<double>(warm_up + ticks) * numbers.ecology.tick_s, before, files, after, warm);
    Clock::enter(Part::bodies);
    state.SetIterationTime(warm.elapsed_s() / static_cast<double>(ticks));
  }

  double all_s = 0.0;
  for (const double part_s : Clock::spent_s) all_s += part_s;
  const auto share = [&](std::size_t part) { return 100.0 * Clock::spent_s.at(part) / all_s; };
  for (std::size_t part = 0; part < part_names.size(); ++part) state.counters[part_names.at(part)] = share(part);
  state.counters["rules_%"] = 100.0 - share(static_cast<std::size_t>(Part::bodies)) - share(static_cast<std::size_t>(Part::logs));
  const auto robots = static_cast<double>(numbers.ecology.robots);
  state.counters["us/robot"] = warm.elapsed_s() * 1e6 / static_cast<double>(ticks) / robots;
  state.counters["bytes/robot"] = (test::resident_bytes() - before_bytes) / robots;
  state.counters["predators_%"] = 100.0 * static_cast<double>(ecology.view().count(1)) / robots;
}

void kinematic(benchmark::State& state) {
  tick<backend::Kinematic>(state, 30, 10);
}
void mujoco(benchmark::State& state) {
  const std::int64_t ticks = state.range(0) > 10'000 ? 1 : 3;
  tick<backend::Mujoco>(state, ticks, ticks);
}

using Eyes = perception::sensors::Rays<8, perception::sensors::Sees::victims, perception::sensors::Sees::hunters>;
using PondWithEyes = with_brain<with_sensors<worlds::Pond, perception::sensors::List<Eyes>>, control::brain::FeedForwardBrain>;

/// Ticks of the pond with eyes of rays, with all tables of a run's folder, no recording, and a checkpoint at the end. Room and
/// food grow with the number of bodies, of which 40 % have an individual at the start. The time reported is the processor's for
/// one tick; the peak of memory includes the checkpoint.
void pond(benchmark::State& state) {
  constexpr std::int64_t warm_up = 30;
  constexpr std::int64_t ticks = 10;
  Experiment<PondWithEyes> numbers;
  numbers.ecology.robots = static_cast<std::size_t>(state.range(0));
  const double times = static_cast<double>(numbers.ecology.robots) / 150.0;
  numbers.rules.community.predators = static_cast<std::size_t>(12.0 * times);
  numbers.rules.recruitment.spare_bodies = static_cast<std::size_t>(90.0 * times);
  numbers.rules.resource.cells_in_a_row = static_cast<std::size_t>(20.0 * std::sqrt(times));
  Habitat habitat = load_habitat(numbers.ecology);
  habitat.arena.half_side_m *= std::sqrt(times);

  ::malloc_trim(0);
  test::forget_peak();
  const double before_bytes = test::peak_bytes();
  Ecology<PondWithEyes> ecology{numbers, backend::Kinematic::Params{}, std::move(habitat)};
  const trophic::test::TemporaryFolder folder;
  io::RunFolder files{folder.path() / "run", {}, {.replay_hz = 0.0, .agents_every_ticks = 1}};
  WarmUp warm{warm_up};
  double living = 0.0;
  for (auto _ : state) {
    ecology.run_until(static_cast<double>(warm_up + ticks) * numbers.ecology.tick_s, files, warm);
    state.SetIterationTime(warm.elapsed_s() / static_cast<double>(ticks));
    living = static_cast<double>(ecology.view().count(0) + ecology.view().count(1));
  }
  checkpoint::run_with_checkpoints(ecology, ecology.time_s(), folder.path() / "run", {}, {}, files);
  const auto robots = static_cast<double>(numbers.ecology.robots);
  state.counters["us/robot"] = warm.elapsed_s() * 1e6 / static_cast<double>(ticks) / robots;
  state.counters["us/living"] = warm.elapsed_s() * 1e6 / static_cast<double>(ticks) / living;
  state.counters["peak_bytes/robot"] = (test::peak_bytes() - before_bytes) / robots;
  state.counters["living_%"] = 100.0 * living / robots;
}

/// Ticks of wolves, sheep and grass with the numbers of PPHPC's first parameter set, on so many patches in a row, without files.
/// tests/bench/wolf_sheep.py has the same world in Python and in Mesa.
void wolf_sheep(benchmark::State& state) {
  constexpr std::int64_t warm_up = 100;
  constexpr std::int64_t ticks = 20;
  Experiment<worlds::WolfSheep> numbers;
  const auto side = static_cast<std::size_t>(state.range(0));
  const std::size_t parts = side * side / 100;
  numbers.ecology.robots = 60 * parts;
  numbers.rules.community.predators = 2 * parts;
  numbers.rules.recruitment.get<0>().spare_bodies = 54 * parts;
  numbers.rules.resource.patches_in_a_row = side;
  numbers.rules.resource.delay_ticks = 10;
  Habitat habitat = load_habitat(numbers.ecology);
  habitat.arena.half_side_m = 0.5 * static_cast<double>(side);
  Ecology<worlds::WolfSheep> ecology{numbers, backend::Torus::Params{}, std::move(habitat)};
  WarmUp warm{warm_up};
  for (auto _ : state) {
    ecology.run_until(static_cast<double>(warm_up + ticks) * numbers.ecology.tick_s, warm);
    state.SetIterationTime(warm.elapsed_s() / static_cast<double>(ticks));
  }
  state.counters["living"] = static_cast<double>(ecology.view().count(0) + ecology.view().count(1));
  state.counters["4000_ticks_s"] = 4000.0 * warm.elapsed_s() / static_cast<double>(ticks);
}

constexpr std::size_t living = 1000;

struct Reaper {
  static constexpr std::string_view name = "reaper";
  struct Params {
    double share = 0.0;
    static constexpr auto fields() { return std::tuple{field("share", &Params::share)}; }
  };
  Params params;
  [[nodiscard]] bool dies(const Individual&, const View&, Rng& rng) const { return rng.chance(params.share); }
};
/// Individuals have offspring next to them until `living` are there.
struct Nurse {
  static constexpr std::string_view name = "nurse";
  [[nodiscard]] std::size_t spare_bodies() const { return living; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return true; }
  [[nodiscard]] std::vector<reproduction::Recruit> recruits(const View& view, Rng&) const {
    std::vector<reproduction::Recruit> births;
    const std::size_t there = view.count(0) + view.count(1);
    while (there > 0 && there + births.size() < living) {
      for (const Individual& one : view.robots) {
        if (one.lives() && there + births.size() < living)
          births.push_back({.species = one.species, .parents = {one.as_ancestor()}});
      }
    }
    return births;
  }
};

/// Ticks of 1000 living on MuJoCo, of whom so many die each second, and so many are born. The time is the processor's for a tick.
void turnover(benchmark::State& state) {
  using Rules = with_recruitment<with_senescence<rules::Paper, Reaper>, Nurse>;
  Experiment<Rules> numbers;
  numbers.ecology.robots = 2 * living;
  numbers.ecology.arena = "walled_by_density";
  numbers.rules.community.predators = living * 14 / 30;
  numbers.rules.senescence.share = static_cast<double>(state.range(0)) * numbers.ecology.tick_s / static_cast<double>(living);
  Ecology<Rules> ecology{numbers, backend::Mujoco::Params{}};
  observe::Tally tally;
  WarmUp warm{2};
  constexpr double ticks = 3.0;
  for (auto _ : state) {
    ecology.run_until((2.0 + ticks) * numbers.ecology.tick_s, tally, warm);
    state.SetIterationTime(warm.elapsed_s() / ticks);
  }
  state.counters["deaths/s"] = static_cast<double>(tally.deaths()) / ecology.time_s();
  state.counters["living"] = static_cast<double>(ecology.view().count(0) + ecology.view().count(1));
}

}  // namespace

BENCHMARK(turnover)->ArgName("deaths/s")->Arg(0)->Arg(300)->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(pond)
    ->ArgName("robots")
    ->RangeMultiplier(10)
    ->Range(100, 100'000)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(wolf_sheep)
    ->ArgName("side")
    ->Arg(100)
    ->Arg(200)
    ->Arg(400)
    ->Arg(800)
    ->Arg(1600)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(kinematic)
    ->ArgNames({"robots", "agents_every"})
    ->ArgsProduct({{1000, 10'000, 100'000}, {1, 10}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(mujoco)
    ->ArgNames({"robots", "agents_every"})
    ->ArgsProduct({{1000, 10'000, 100'000}, {1}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
