// SPDX-License-Identifier: MIT
// What a tick costs beside its physics: rules, perception, brains, gait control and logging, with and without MuJoCo.
#include <benchmark/benchmark.h>

#include <stop_token>
#include <support/temporary_folder.hpp>
#include <thread>
#include <trophic/backend/mujoco.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/agent_log.hpp>
#include <trophic/io/event_log.hpp>
#include <trophic/io/genome_log.hpp>
#include <trophic/rules/paper.hpp>

namespace {

/// Takes servo targets and leaves the robots where they are, so that all the rest of a tick is what is measured.
class NoPhysics {
 public:
  static constexpr std::string_view name = "no_physics";
  static std::string version() { return "1"; }
  static std::vector<std::string> remarks(const trophic::Physics&) { return {}; }
  struct Params {
    using Backend = NoPhysics;
  };
  using State = int;

  NoPhysics(const trophic::RobotModel& robot, const trophic::Arena&, std::span<const trophic::Pose> starts,
            const trophic::Physics&, const Params&)
      : poses_{starts.begin(), starts.end()}, targets_rad_(starts.size() * robot.hinges.size()) {}

  void advance_to(double time_s) { time_s_ = time_s; }
  void set_joint_targets(std::size_t robot, std::span<const double> targets_rad) {
    std::ranges::copy(targets_rad, targets_rad_.begin() + static_cast<std::ptrdiff_t>(robot * targets_rad.size()));
    benchmark::DoNotOptimize(targets_rad_.data());
  }
  [[nodiscard]] std::size_t robots() const { return poses_.size(); }
  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] trophic::Pose pose(std::size_t robot) const { return poses_[robot]; }
  [[nodiscard]] std::span<const double> joint_angles(std::size_t) const { return {}; }
  [[nodiscard]] State save() const { return 0; }
  void restore(const State&) {}

 private:
  std::vector<trophic::Pose> poses_;
  std::vector<double> targets_rad_;
  double time_s_ = 0.0;
};
static_assert(trophic::JointDriven<NoPhysics>);

/// Ten ticks of the paper's rules with events, agents and genomes logged; the time reported is that of one.
template <class Backend>
void tick(benchmark::State& state, const typename Backend::Params& params) {
  constexpr int ticks = 10;
  trophic::EcologyParams numbers = trophic::rules::Paper::ecology();
  numbers.robots = static_cast<std::size_t>(state.range(0));
  trophic::Ecology<trophic::rules::Paper> ecology({.ecology = numbers}, params);
  const trophic::test::TemporaryFolder folder;
  trophic::io::EventLog events{folder.path() / "events.csv"};
  trophic::io::AgentLog agents{folder.path() / "agents.csv"};
  trophic::io::GenomeLog genomes{folder.path() / "genomes.csv"};
  for (auto _ : state) ecology.run_until(ecology.time_s() + ticks * numbers.tick_s, events, agents, genomes);
  state.counters["tick_ms"] = benchmark::Counter(static_cast<double>(state.iterations()) * ticks * 1e-3,
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void tick_without_physics(benchmark::State& state) {
  tick<NoPhysics>(state, {});
}

/// Beside so many loops that do nothing and never rest, as on a machine with other programs.
void tick_on_mujoco(benchmark::State& state) {
  std::vector<std::jthread> busy;
  for (int i = 0; i < state.range(2); ++i) {
    busy.emplace_back([](const std::stop_token& stop) {
      while (!stop.stop_requested()) continue;
    });
  }
  tick<trophic::backend::Mujoco>(state, {.threads = static_cast<std::size_t>(state.range(1))});
}

}  // namespace

BENCHMARK(tick_without_physics)->ArgName("robots")->Arg(30)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(tick_on_mujoco)
    ->ArgNames({"robots", "threads", "busy"})
    ->Args({30, 1, 0})
    ->Args({30, 2, 0})
    ->Args({30, 1, 4})
    ->Args({30, 2, 4})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
