// SPDX-License-Identifier: MIT
// Benchmark of the paper's run on MuJoCo: stretches of three seeds in which robots have locked, in each way of stepping.
//   bench_paper          runs each seed to where its stretch begins, then times the stretches, way by way, three rounds
//   bench_paper --whole  runs each seed to its end and compares its processor time with the stretch's, on one thread
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <trophic/backend/mujoco.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

namespace {

using trophic::backend::Mujoco;
using Paper = trophic::Ecology<trophic::rules::Paper>;

constexpr std::array<std::uint64_t, 3> seeds{1, 2, 3};
/// Where the stretches begin on the ecology's clock, and how long each is.
constexpr double start_s = 1700.0;
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
  Spent& operator+=(const Spent& other) {
    wall_s += other.wall_s;
    processor_s += other.processor_s;
    return *this;
  }
  Spent operator-(const Spent& before) const { return {wall_s - before.wall_s, processor_s - before.processor_s}; }
};

/// Goes on to a time of the ecology's clock, with rules, gait and brains but without logs; returns what that took.
Spent run(Paper& ecology, double until_s) {
  const Spent before = Spent::now();
  ecology.run_until(until_s);
  return Spent::now() - before;
}

/// The median of each way's rounds, as seconds for a whole run.
void time_stretches() {
  std::vector<std::string> starts;
  for (const std::uint64_t seed : seeds) {
    std::fprintf(stderr, "seed %d to %g s\n", static_cast<int>(seed), start_s);
    Paper ecology{{.seed = seed}, ways[3].params};
    run(ecology, start_s);
    trophic::Archive archive;
    ecology.persist(archive);
    starts.push_back(archive.bytes());
  }
  std::array<std::vector<Spent>, ways.size()> measured;
  std::string profile;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t way = 0; way < ways.size(); ++way) {
      std::fprintf(stderr, "round %d: %s\n", round, ways[way].name);
      Spent sum{};
      for (std::size_t i = 0; i < seeds.size(); ++i) {
        Paper ecology{{.seed = seeds[i]}, ways[way].params};
        trophic::Archive archive{starts[i]};
        ecology.persist(archive);
        sum += run(ecology, start_s + stretch_s);
        if (way == 3 && round == 0) profile += "  " + ecology.backend().speed_remark(true) + "\n";
      }
      measured[way].push_back(sum);
    }
  }
  constexpr double runs = whole_run_s / stretch_s / static_cast<double>(seeds.size());
  const auto median = [&](std::size_t way, double Spent::*part) {
    std::ranges::sort(measured[way], {}, part);
    return runs * measured[way][rounds / 2].*part;
  };
  std::printf("The paper's run, seeds 1 to 3, %g s from %g s on, as seconds for %g s; 1/x: x times faster than one model\n",
              stretch_s, start_s, whole_run_s);
  for (std::size_t way = 0; way < ways.size(); ++way) {
    std::printf("%12s %9.1f s  1/%-7.1f %9.1f s of processor time\n", ways[way].name, median(way, &Spent::wall_s),
                median(0, &Spent::wall_s) / median(way, &Spent::wall_s), median(way, &Spent::processor_s));
  }
  std::printf("%s", profile.c_str());
}

/// Returns whether the stretches' figure is within 10 % of the whole runs' processor time.
bool compare_whole() {
  double whole_s = 0.0;
  double stretches_s = 0.0;
  for (const std::uint64_t seed : seeds) {
    Paper ecology{{.seed = seed}, ways[3].params};
    for (double at_s = 0; at_s < whole_run_s; at_s += stretch_s) {
      const bool is_stretch = at_s <= start_s && start_s < at_s + stretch_s;
      double chunk_s = run(ecology, at_s + stretch_s).processor_s;
      whole_s += chunk_s;
      if (is_stretch) stretches_s += chunk_s;
      std::printf("CHUNK %d %g %.4f %s\n", static_cast<int>(seed), at_s, chunk_s, ecology.backend().speed_remark(true).c_str());
      std::fflush(stdout);
    }
  }
  const double figure_s = stretches_s * whole_run_s / stretch_s;
  std::printf("whole runs %.1f s, by their stretches %.1f s: %+.1f %%\n", whole_s, figure_s, 100.0 * (figure_s / whole_s - 1.0));
  return figure_s > 0.9 * whole_s && figure_s < 1.1 * whole_s;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view{argv[1]} == "--whole") return compare_whole() ? 0 : 1;
  time_stretches();
  return 0;
}
