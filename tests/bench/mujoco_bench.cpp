// SPDX-License-Identifier: MIT
// Benchmark of the MuJoCo backend: one big model against islands, interleaved, with their ratios at the end.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <memory>
#include <mujoco/worlds.hpp>
#include <string>
#include <vector>

namespace {

using trophic::backend::Mujoco;
using Stepping = Mujoco::Stepping;

/// A world that goes on walking from one measurement to the next.
struct World {
  Mujoco backend;
};

World& world_of(std::size_t robots, Stepping stepping, std::size_t threads) {
  static std::map<std::tuple<std::size_t, Stepping, std::size_t>, std::unique_ptr<World>> worlds;
  std::unique_ptr<World>& world = worlds[{robots, stepping, threads}];
  if (!world) {
    const trophic::RobotModel spider = trophic::body::load_robot("spider");
    const double spacing_m = 19.0 / std::ceil(std::sqrt(static_cast<double>(robots)));
    const std::vector<trophic::Pose> starts = trophic::test::lattice(spider, robots, spacing_m);
    const trophic::Arena arena = trophic::load_arena("walled_square");
    const Mujoco::Params params{.stepping = stepping, .threads = threads};
    world = std::make_unique<World>(World{Mujoco{spider, arena, starts, trophic::Physics{}, params}});
    trophic::test::walk(world->backend, 0.5);
  }
  return *world;
}

/// One iteration is one control tick of the whole world; the measure is microseconds per physics step.
void control_tick(benchmark::State& state, std::size_t robots, Stepping stepping, std::size_t threads) {
  Mujoco& backend = world_of(robots, stepping, threads).backend;
  const double before_s = backend.time_s();
  for (auto _ : state) trophic::test::walk(backend, backend.time_s() + trophic::test::control_period_s);
  const double steps = (backend.time_s() - before_s) / trophic::Physics{}.timestep_s;
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
