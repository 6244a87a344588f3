// SPDX-License-Identifier: MIT
// What a step of one robot costs in each engine, processor time: runs interleaved, ratios to MuJoCo's islands at the end.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdio>
#include <map>
#include <mujoco/worlds.hpp>
#include <string>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/ode.hpp>
#include <vector>

namespace {

using trophic::backend::Mujoco;
using trophic::backend::Ode;
using trophic::backend::ode::Solver;

constexpr std::size_t robots = 30;

template <class B>
B world(const typename B::Params& params) {
  const trophic::RobotModel spider = trophic::load_robot("spider");
  const auto starts = trophic::test::lattice(spider, robots, 3.0);
  B backend{spider, trophic::load_arena("walled_square"), starts, trophic::Physics{}, params};
  trophic::test::walk(backend, 0.5);
  return backend;
}

/// One iteration is one control tick of 30 robots, each with its own gait, on one thread.
template <class B>
void control_tick(benchmark::State& state, const typename B::Params& params) {
  B backend = world<B>(params);
  const double before_s = backend.time_s();
  for (auto _ : state) trophic::test::walk(backend, backend.time_s() + trophic::test::control_period_s);
  const double robot_steps = static_cast<double>(robots) * (backend.time_s() - before_s) / trophic::Physics{}.timestep_s;
  state.counters["us/robot-step"] =
      benchmark::Counter(robot_steps * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Prints the usual table, and keeps each benchmark's median.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.aggregate_name == "median") medians_[run.run_name.function_name] = run.counters.at("us/robot-step").value;
    }
  }
  void print_ratios() const {
    const auto reference = medians_.find("mujoco_islands");
    if (reference == medians_.end()) return;
    std::printf("\n%-24s %16s %28s\n", "", "us/robot-step", "ratio to MuJoCo's islands");
    for (const auto& [name, us] : medians_) std::printf("%-24s %16.2f %28.2f\n", name.c_str(), us, us / reference->second);
  }

 private:
  std::map<std::string, double> medians_;
};

template <class B>
void add(const char* name, const typename B::Params& params) {
  benchmark::RegisterBenchmark(name, control_tick<B>, params)
      ->Unit(benchmark::kMillisecond)
      ->MinTime(0.3)
      ->Repetitions(7)
      ->ReportAggregatesOnly();
}

}  // namespace

int main(int argc, char** argv) {
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments{argv, argv + argc};
  arguments.insert(arguments.begin() + 1, interleave.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  add<Mujoco>("mujoco_fast", {});
  add<Mujoco>("mujoco_islands", {.stepping = Mujoco::Stepping::islands});
  add<Ode>("ode_quick_step_8", {});
  add<Ode>("ode_quick_step_20", {.sweeps = 20});
  add<Ode>("ode_world_step", {.solver = Solver::world_step});
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_ratios();
  return 0;
}
