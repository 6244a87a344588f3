// SPDX-License-Identifier: MIT
// Benchmark of the MuJoCo backend: one big model against islands, interleaved, with their ratios at the end.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <mujoco/worlds.hpp>
#include <span>
#include <string>
#include <trophic/control/cpg.hpp>
#include <trophic/control/gait.hpp>
#include <tuple>
#include <vector>

namespace {

using trophic::backend::Mujoco;
using Stepping = Mujoco::Stepping;

/// A world that goes on walking from one measurement to the next. Each robot has a gait of its own, with weights uniform in
/// [-1, 1] as the paper's evolution starts from: one shared gait would keep the robots in step with each other.
class World {
 public:
  World(const trophic::RobotModel& robot, std::span<const trophic::Pose> starts, const Mujoco::Params& params)
      : backend_{robot, trophic::load_arena("walled_square"), starts, trophic::Physics{}, params} {
    trophic::control::Gait gait = trophic::control::load_gait("spider_published");
    for (std::size_t i = 0; i < starts.size(); ++i) {
      trophic::Rng rng{5, trophic::Stream::user, i};
      for (double& weight : gait.internal) weight = rng.uniform(-1.0, 1.0);
      for (Eigen::Index row = 0; row < gait.coupling.rows(); ++row) {
        for (Eigen::Index column = 0; column < row; ++column) {
          gait.coupling(row, column) = rng.uniform(-1.0, 1.0);
          gait.coupling(column, row) = -gait.coupling(row, column);
        }
      }
      cpgs_.emplace_back(gait);
      states_.push_back(cpgs_.back().initial_states());
    }
  }

  void control_tick() {
    std::array<double, 4> targets_rad{};
    for (std::size_t i = 0; i < cpgs_.size(); ++i) {
      cpgs_[i].outputs(states_[i], 0, targets_rad);
      backend_.set_joint_targets(i, targets_rad);
      cpgs_[i].step(states_[i]);
    }
    backend_.advance_to(static_cast<double>(++ticks_) / 60.0);
  }

  [[nodiscard]] double time_s() const { return backend_.time_s(); }

 private:
  Mujoco backend_;
  std::vector<trophic::control::Cpg> cpgs_;
  std::vector<Eigen::MatrixXd> states_;
  std::size_t ticks_ = 0;
};

World& world_of(std::size_t robots, Stepping stepping, std::size_t threads) {
  static std::map<std::tuple<std::size_t, Stepping, std::size_t>, std::unique_ptr<World>> worlds;
  std::unique_ptr<World>& world = worlds[{robots, stepping, threads}];
  if (!world) {
    const trophic::RobotModel spider = trophic::body::load_robot("spider");
    const double spacing_m = 19.0 / std::ceil(std::sqrt(static_cast<double>(robots)));
    std::vector<trophic::Pose> starts = trophic::test::lattice(spider, robots, spacing_m);
    // Dropped with moving legs: 300 robots flat on their bellies make more contacts than one model has room for.
    for (trophic::Pose& start : starts) start.position_m.z() += 0.1;
    world = std::make_unique<World>(spider, starts, Mujoco::Params{.stepping = stepping, .threads = threads});
    for (int tick = 0; tick < 30; ++tick) world->control_tick();
  }
  return *world;
}

/// One iteration is one control tick of the whole world; the measure is microseconds per physics step.
void control_tick(benchmark::State& state, std::size_t robots, Stepping stepping, std::size_t threads) {
  World& world = world_of(robots, stepping, threads);
  const double before_s = world.time_s();
  for (auto _ : state) world.control_tick();
  const double steps = (world.time_s() - before_s) / trophic::Physics{}.timestep_s;
  state.counters["us/step"] = benchmark::Counter(steps * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Prints the usual table, and keeps each benchmark's median.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.aggregate_name == "median") us_per_step_[run.run_name.function_name] = run.counters.at("us/step").value;
    }
  }

  void print_ratios() const {
    std::printf("\n%7s %10s %24s %24s\n", "robots", "one model", "islands, 1 thread", "islands, 2 threads");
    for (const std::size_t robots : {30U, 100U, 300U}) {
      const auto find = [&](const std::string& way) { return us_per_step_.find(way + "/" + std::to_string(robots)); };
      const auto whole = find("one_model");
      if (whole == us_per_step_.end()) continue;
      std::printf("%7zu %7.0f us", robots, whole->second);
      for (const char* way : {"islands_1", "islands_2"}) {
        if (const auto part = find(way); part != us_per_step_.end()) {
          std::printf("     %7.0f us = 1/%-7.2f", part->second, whole->second / part->second);
        }
      }
      std::printf("\n");
    }
    std::printf("(microseconds per step of the whole world, medians; 1/x: x times faster than one model)\n");
  }

 private:
  std::map<std::string, double> us_per_step_;
};

}  // namespace

int main(int argc, char** argv) {
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments{argv, argv + argc};
  arguments.insert(arguments.begin() + 1, interleave.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  for (const std::size_t robots : {30U, 100U, 300U}) {
    const auto add = [&](const std::string& way, Stepping stepping, std::size_t threads) {
      benchmark::RegisterBenchmark((way + "/" + std::to_string(robots)).c_str(), control_tick, robots, stepping, threads)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime()
          ->MinTime(0.3)
          ->Repetitions(7)
          ->ReportAggregatesOnly();
    };
    add("one_model", Stepping::one_model, 1);
    add("islands_1", Stepping::islands, 1);
    add("islands_2", Stepping::islands, 2);
  }
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_ratios();
  return 0;
}
