// SPDX-License-Identifier: MIT
// Benchmark of the MuJoCo backend: the ways of stepping against one big model, interleaved; speed and memory over the number of
// robots.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <mujoco/worlds.hpp>
#include <optional>
#include <string>
#include <support/memory.hpp>
#include <trophic/control/locomotion/cpg.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <tuple>
#include <vector>

namespace {

using trophic::backend::Mujoco;
using Stepping = Mujoco::Stepping;

/// Side of a robot's share of the floor, m, from 300 robots on: 300 fill the paper's arena, more have a larger one.
constexpr double densest_spacing_m = 19.0 / 18.0;
/// Distance of neighbours in a crowd at first, m: 1.1 diameters of a spider's sphere.
constexpr double dense_spacing_m = 0.45;

/// A way of stepping a world of so many robots.
struct Way {
  std::string name;
  Stepping stepping;
  std::size_t threads;
  std::size_t kinds = 1;  ///< of bodies, in turn
  bool is_dense = false;  ///< so close that several robots touch others at any time
};
const std::array<Way, 5> ways{Way{"one_model", Stepping::one_model, 1}, Way{"islands_1", Stepping::islands, 1},
                              Way{"islands_2", Stepping::islands, 2}, Way{"fast_1", Stepping::fast, 1},
                              Way{"fast_2", Stepping::fast, 2}};

/// Robots of several bodies, whose servos brake a thousandth more from one to the next so that they move alike; and crowds of
/// them.
const std::array<Way, 10> mixed_ways{Way{"apart_1", Stepping::fast, 1, 1},
                                     Way{"apart_2", Stepping::fast, 1, 2},
                                     Way{"apart_30", Stepping::fast, 1, 30},
                                     Way{"apart_30_islands", Stepping::islands, 1, 30},
                                     Way{"dense_1", Stepping::fast, 1, 1, true},
                                     Way{"dense_2", Stepping::fast, 1, 2, true},
                                     Way{"dense_30", Stepping::fast, 1, 30, true},
                                     Way{"dense_1_islands", Stepping::islands, 1, 1, true},
                                     Way{"dense_30_islands", Stepping::islands, 1, 30, true},
                                     Way{"dense_1_one_model", Stepping::one_model, 1, 1, true}};

/// The most memory that the process held since `forget_peak`, bytes.
void forget_peak() {
  std::ofstream{"/proc/self/clear_refs"} << "5";
}
double peak_bytes() {
  std::ifstream file{"/proc/self/status"};
  for (std::string word; file >> word;) {
    double kilobytes = 0.0;
    if (word == "VmHWM:" && file >> kilobytes) return 1024.0 * kilobytes;
  }
  return 0.0;
}

/// The paper's arena, or one in which each robot has as much room as 300 have there.
trophic::Arena arena_for(std::size_t robots) {
  trophic::Arena arena = trophic::load_arena("walled_square");
  const double side_m = densest_spacing_m * std::ceil(std::sqrt(static_cast<double>(robots))) + 1.0;
  if (0.5 * side_m > arena.half_side_m) {
    arena.half_side_m = 0.5 * side_m;
    arena.extent_m = side_m;
  }
  return arena;
}

/// A world that goes on walking from one measurement to the next. Each robot has a gait of its own, with weights uniform in
/// [-1, 1] as the paper's evolution starts from: one shared gait would keep the robots in step with each other.
class World {
 public:
  World(std::size_t robots, const Way& way) {
    trophic::Gait gait = trophic::load_gait("spider_published");
    for (std::size_t i = 0; i < robots; ++i) {
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
    const trophic::RobotModel spider = trophic::load_robot("spider");
    const trophic::Arena arena = arena_for(robots);
    const double columns = std::ceil(std::sqrt(static_cast<double>(robots)));
    const double spacing_m = way.is_dense ? dense_spacing_m : (2.0 * arena.half_side_m - 1.0) / columns;
    std::vector<trophic::Pose> starts = trophic::test::lattice(spider, robots, spacing_m);
    // Dropped with moving legs: 300 robots flat on their bellies make more contacts than one model has room for.
    for (trophic::Pose& start : starts) start.position_m.z() += 0.1;
    ::malloc_trim(0);
    const double before_bytes = trophic::test::resident_bytes();
    forget_peak();
    backend_.emplace(spider, arena, starts, trophic::Physics{}, Mujoco::Params{.stepping = way.stepping, .threads = way.threads});
    for (std::size_t i = 0; i < robots && way.kinds > 1; ++i) {
      trophic::RobotModel body = spider;
      for (trophic::Hinge& hinge : body.hinges) hinge.servo.velocity_gain *= 1.0 + 0.001 * static_cast<double>(i % way.kinds);
      backend_->embody(i, body, starts[i]);
    }
    const int ticks = robots > 1000 ? 15 : 30;
    for (int tick = 0; tick < ticks; ++tick) control_tick();
    bytes_ = peak_bytes() - before_bytes;
  }

  /// Advances by one control tick; returns the seconds that the backend took for it.
  double control_tick() {
    std::array<double, 4> targets_rad{};
    for (std::size_t i = 0; i < cpgs_.size(); ++i) {
      cpgs_[i].outputs(states_[i], 0, targets_rad);
      backend_->set_joint_targets(i, targets_rad);
      cpgs_[i].step(states_[i]);
    }
    const auto start = std::chrono::steady_clock::now();
    backend_->advance_to(static_cast<double>(++ticks_) / 60.0);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  [[nodiscard]] double time_s() const { return backend_->time_s(); }
  /// The most memory that the backend held beyond what there was before it.
  [[nodiscard]] double bytes() const { return bytes_; }

 private:
  std::vector<trophic::locomotion::Cpg> cpgs_;
  std::vector<Eigen::MatrixXd> states_;
  std::optional<Mujoco> backend_;
  std::size_t ticks_ = 0;
  double bytes_ = 0.0;
};

/// The world of a benchmark.
World& world_of(std::size_t robots, const Way& way) {
  static std::map<std::tuple<std::size_t, std::string>, std::unique_ptr<World>> worlds;
  std::unique_ptr<World>& world = worlds[{robots, way.name}];
  if (!world) world = std::make_unique<World>(robots, way);
  return *world;
}

/// One iteration is one control tick of the whole world; the measure is microseconds per physics step.
void control_tick(benchmark::State& state, std::size_t robots, const Way& way) {
  World& world = world_of(robots, way);
  const double before_s = world.time_s();
  for (auto _ : state) state.SetIterationTime(world.control_tick());
  const double steps = (world.time_s() - before_s) / trophic::Physics{}.timestep_s;
  state.counters["us/step"] = benchmark::Counter(steps * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes"] = world.bytes();
}

/// Prints the usual lines to the error output, and keeps each benchmark's median.
class Tables : public benchmark::ConsoleReporter {
 public:
  Tables() : ConsoleReporter{OO_Tabular} { SetOutputStream(&std::cerr); }

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.aggregate_name != "median") continue;
      measured_[run.run_name.function_name] = {run.counters.at("us/step").value, run.counters.at("bytes").value};
    }
  }

  void print() const {
    std::printf("Microseconds per step of the whole world, medians; 1/x: x times faster than one model\n%7s", "robots");
    for (const Way& way : ways) std::printf("%20s", way.name.c_str());
    for (const std::size_t robots : {1U, 30U, 100U, 300U}) {
      const Measured* const whole = find("one_model", robots);
      if (whole == nullptr) continue;
      std::printf("\n%7zu %19.1f", robots, whole->us_per_step);
      for (std::size_t i = 1; i < ways.size(); ++i) {
        const Measured* const part = find(ways[i].name, robots);
        if (part == nullptr) continue;
        std::printf("%9.1f = 1/%-7.1f", part->us_per_step, whole->us_per_step / part->us_per_step);
      }
    }
    std::printf("\n\n%7s%20s%20s%20s%20s\n", "robots", "one model, steps/s", "fast_1, steps/s", "fast_2, steps/s",
                "bytes per robot");
    for (const std::size_t robots : {1U, 30U, 100U, 300U, 1000U, 10000U, 100000U}) {
      std::printf("%7zu", robots);
      const Measured* last = nullptr;
      for (const char* way : {"one_model", "fast_1", "fast_2"}) {
        if (const Measured* const part = find(way, robots)) {
          std::printf("%20.0f", static_cast<double>(robots) * 1e6 / part->us_per_step);
          last = part;
        } else {
          std::printf("%20s", "-");
        }
      }
      if (last != nullptr) std::printf("%20.0f", last->bytes / static_cast<double>(robots));
      std::printf("\n");
    }
    std::printf("(steps of one robot per second; memory of the last of the three)\n");
    std::printf("\n30 robots of one, two and thirty kinds of bodies, apart and in a crowd, one thread\n%20s%12s\n", "",
                "us a step");
    for (const Way& way : mixed_ways) {
      if (const Measured* const part = find(way.name, 30)) std::printf("%20s%12.1f\n", way.name.c_str(), part->us_per_step);
    }
  }

 private:
  struct Measured {
    double us_per_step;
    double bytes;
  };

  [[nodiscard]] const Measured* find(const std::string& way, std::size_t robots) const {
    const auto found = measured_.find(way + "/" + std::to_string(robots));
    return found == measured_.end() ? nullptr : &found->second;
  }

  std::map<std::string, Measured> measured_;
};

/// `least_s`: how long each repetition measures at least; 0: three ticks.
void add(const Way& way, std::size_t robots, double least_s, int repetitions) {
  auto* const added = benchmark::RegisterBenchmark((way.name + "/" + std::to_string(robots)).c_str(), control_tick, robots, way);
  added->Unit(benchmark::kMillisecond)->UseManualTime()->Repetitions(repetitions)->ReportAggregatesOnly();
  if (least_s > 0.0) {
    added->MinTime(least_s);
  } else {
    added->Iterations(3);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments{argv, argv + argc};
  arguments.insert(arguments.begin() + 1, interleave.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  for (const std::size_t robots : {1U, 30U, 100U, 300U}) {
    for (const Way& way : ways) add(way, robots, 0.2, 9);
  }
  for (const std::size_t robots : {1000U, 10000U, 100000U}) {
    for (const Way& way : ways) {
      if (way.stepping == Stepping::fast) add(way, robots, robots > 10000 ? 0.0 : 0.2, robots > 10000 ? 3 : 5);
    }
  }
  for (const Way& way : mixed_ways) add(way, 30, 0.2, 5);
  Tables tables;
  benchmark::RunSpecifiedBenchmarks(&tables);
  tables.print();
  return 0;
}
