// SPDX-License-Identifier: MIT
// Benchmark of the paper's run on MuJoCo: a fixed stretch in which robots meet, from one checkpoint, in each way of stepping.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <map>
#include <trophic/backend/mujoco.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

namespace {

using trophic::backend::Mujoco;
using Paper = trophic::Ecology<trophic::rules::Paper>;

/// Where the stretch begins on the ecology's clock, and how long it is.
constexpr double start_s = 1200.0;
constexpr double stretch_s = 20.0;
constexpr double whole_run_s = 6000.0;

struct Way {
  std::string name;
  Mujoco::Stepping stepping;
  std::size_t threads;
};
const std::array<Way, 5> ways{Way{"one_model", Mujoco::Stepping::one_model, 1}, Way{"islands_1", Mujoco::Stepping::islands, 1},
                              Way{"islands_2", Mujoco::Stepping::islands, 2}, Way{"fast_1", Mujoco::Stepping::fast, 1},
                              Way{"fast_2", Mujoco::Stepping::fast, 2}};

/// The run whose robots meet often among a few that were tried.
Paper new_run(Mujoco::Stepping stepping, std::size_t threads) {
  trophic::EcologyParams numbers = trophic::rules::Paper::ecology();
  numbers.gait = "spider_steered";
  return Paper{{.seed = 161574062546064, .ecology = numbers}, Mujoco::Params{.stepping = stepping, .threads = threads}};
}

/// The run at the start of the stretch; made once.
const std::string& checkpoint() {
  static const std::string bytes = [] {
    std::cerr << "running " << start_s << " s to where the stretch begins\n";
    Paper run = new_run(Mujoco::Stepping::fast, 2);
    run.run_until(start_s);
    trophic::Archive archive;
    run.persist(archive);
    return archive.bytes();
  }();
  return bytes;
}

/// How many robots have another within 0.3 m, mean of the ticks seen.
struct Meetings {
  std::size_t ticks = 0;
  std::size_t close = 0;

  void on_tick(const trophic::View& view) {
    constexpr double near_m = 0.3;
    ++ticks;
    for (std::size_t i = 0; i < view.poses.size(); ++i) {
      bool meets = false;
      for (std::size_t j = 0; j < view.poses.size() && !meets; ++j) {
        meets = i != j && trophic::distance_m(view.poses[i], view.poses[j]) < near_m;
      }
      close += meets ? 1 : 0;
    }
  }
  [[nodiscard]] double mean() const { return static_cast<double>(close) / static_cast<double>(std::max<std::size_t>(ticks, 1)); }
};

/// One iteration is the stretch, with its rules, gait and brains but without logs; the counter is seconds for the whole run.
void stretch(benchmark::State& state, const Way& way) {
  Paper run = new_run(way.stepping, way.threads);
  Meetings meetings;
  for (auto _ : state) {
    trophic::Archive archive{checkpoint()};
    run.persist(archive);
    const auto begin = std::chrono::steady_clock::now();
    run.run_until(start_s + stretch_s, meetings);
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  state.counters["s/run"] = benchmark::Counter(static_cast<double>(state.iterations()) * stretch_s / whole_run_s,
                                               benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["close"] = meetings.mean();
}

/// Prints the usual lines to the error output, and keeps each way's median.
class Table : public benchmark::ConsoleReporter {
 public:
  Table() : ConsoleReporter{OO_Tabular} { SetOutputStream(&std::cerr); }

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.aggregate_name != "median") continue;
      measured_[run.run_name.function_name] = {run.counters.at("s/run").value, run.counters.at("close").value};
    }
  }

  void print() const {
    std::printf("\nThe paper's run, %g s from %g s on, as seconds for %g s; 1/x: x times faster than one model\n", stretch_s,
                start_s, whole_run_s);
    const auto whole = measured_.find("one_model");
    for (const auto& [name, measured] : measured_) {
      std::printf("%12s %9.1f s", name.c_str(), measured.run_s);
      if (whole != measured_.end()) std::printf("  1/%-7.1f", whole->second.run_s / measured.run_s);
      std::printf("  %.1f robots within 0.3 m of another\n", measured.close);
    }
  }

 private:
  struct Measured {
    double run_s;
    double close;
  };
  std::map<std::string, Measured> measured_;
};

}  // namespace

int main(int argc, char** argv) {
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments{argv, argv + argc};
  arguments.insert(arguments.begin() + 1, interleave.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  for (const Way& way : ways) {
    benchmark::RegisterBenchmark(way.name.c_str(), stretch, way)
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1)
        ->Repetitions(3)
        ->ReportAggregatesOnly();
  }
  Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  table.print();
  return 0;
}
