// SPDX-License-Identifier: MIT
// Benchmark of the paper's run on MuJoCo: three seeds, whole on one thread, then stretches of them, in which robots have locked,
// in each way of stepping. Ends with 1 unless the stretches promise the whole runs' processor time within 10 %.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <trophic/backend/mujoco.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

namespace {

using trophic::backend::Mujoco;
using Paper = trophic::Ecology<trophic::rules::Paper>;

constexpr std::array<std::uint64_t, 3> seeds{1, 2, 3};
/// Where the stretches begin on the ecology's clock, and how long each is.
constexpr std::array<double, 3> starts_s{500.0, 2500.0, 4500.0};
constexpr double stretch_s = 40.0;
constexpr double whole_run_s = 6000.0;
constexpr int rounds = 3;

struct Way {
  const char* name;
  Mujoco::Params params;
};
const std::array<Way, 5> ways{Way{"one_model", {Mujoco::Stepping::one_model, 1}},
                              Way{"islands_1", {Mujoco::Stepping::islands, 1}}, Way{"islands_2", {Mujoco::Stepping::islands, 2}},
                              Way{"fast_1", {Mujoco::Stepping::fast, 1}}, Way{"fast_2", {Mujoco::Stepping::fast, 2}}};

/// Seconds so far: of the wall, and of the processor for this process.
struct Spent {
  double wall_s;
  double processor_s;
  static Spent now() {
    rusage use{};
    ::getrusage(RUSAGE_SELF, &use);
    return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
            static_cast<double>(use.ru_utime.tv_sec) + 1e-6 * static_cast<double>(use.ru_utime.tv_usec)};
  }
  Spent operator-(const Spent& before) const { return {wall_s - before.wall_s, processor_s - before.processor_s}; }
};

/// Goes on to a time of the ecology's clock, with rules, gait and brains but without logs; returns what that took.
Spent run(Paper& ecology, double until_s) {
  const Spent before = Spent::now();
  ecology.run_until(until_s);
  return Spent::now() - before;
}

/// A run at the start of a stretch.
struct Start {
  std::uint64_t seed;
  double at_s;
  std::string state;
};

/// Runs each seed to its end with `fast` on one thread. Returns the processor time of a run, and adds the starts of its
/// stretches.
double run_whole(std::vector<Start>& starts) {
  double whole_s = 0.0;
  for (const std::uint64_t seed : seeds) {
    Paper ecology{{.seed = seed}, ways[3].params};
    for (const double at_s : starts_s) {
      whole_s += run(ecology, at_s).processor_s;
      trophic::Archive archive;
      ecology.persist(archive);
      starts.push_back({seed, at_s, archive.bytes()});
    }
    whole_s += run(ecology, whole_run_s).processor_s;
    std::printf("seed %d: %s\n", static_cast<int>(seed), ecology.backend().speed_remark(true).c_str());
  }
  return whole_s / static_cast<double>(seeds.size());
}

/// The time of all stretches in one way.
Spent run_stretches(const Way& way, const std::vector<Start>& starts) {
  Spent sum{};
  for (const Start& start : starts) {
    Paper ecology{{.seed = start.seed}, way.params};
    trophic::Archive archive{start.state};
    ecology.persist(archive);
    const Spent spent = run(ecology, start.at_s + stretch_s);
    sum.wall_s += spent.wall_s;
    sum.processor_s += spent.processor_s;
  }
  return sum;
}

}  // namespace

int main() {
  std::vector<Start> starts;
  const double whole_s = run_whole(starts);
  std::array<std::vector<Spent>, ways.size()> measured;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t way = 0; way < ways.size(); ++way) measured[way].push_back(run_stretches(ways[way], starts));
  }
  const double runs = whole_run_s / stretch_s / static_cast<double>(starts.size());
  const auto median = [&](std::size_t way, double Spent::*part) {
    std::ranges::sort(measured[way], {}, part);
    return runs * measured[way][rounds / 2].*part;
  };
  std::printf("\nThe paper's run, %zu stretches of %g s, as seconds for %g s; 1/x: x times faster than one model\n",
              starts.size(), stretch_s, whole_run_s);
  for (std::size_t way = 0; way < ways.size(); ++way) {
    const double wall_s = median(way, &Spent::wall_s);
    std::printf("%12s %9.1f s  1/%-7.1f %9.1f s of processor time\n", ways[way].name, wall_s, median(0, &Spent::wall_s) / wall_s,
                median(way, &Spent::processor_s));
  }
  const double error = median(3, &Spent::processor_s) / whole_s - 1.0;
  std::printf("the whole run takes %.1f s of processor time; its stretches promise %+.1f %%\n", whole_s, 100.0 * error);
  return std::abs(error) < 0.1 ? 0 : 1;
}
