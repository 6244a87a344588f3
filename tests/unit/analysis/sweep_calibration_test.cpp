// SPDX-License-Identifier: MIT
// Error rates of a sweep's corrected intervals and conclusions equal their nominal ones, and the planned number of runs finds
// the effect: thousands of simulated sweeps.
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <tools/analysis/report/cell_differences.hpp>
#include <tools/analysis/statistics/power.hpp>
#include <trophic/support/rng.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

/// Sweeps of one metric: values are normal, cells differ in mean and spread, replicates of one seed are alike.
struct World {
  std::size_t cells = 6;
  std::size_t replicates = 8;
  bool paired = true;
  double shared = 0.7;    ///< deviation of the part that replicates of one seed have in common
  double own = 1.0;       ///< deviation of each run's own part
  double widening = 0.0;  ///< how much larger `own` is in each further cell
  double effect = 0.0;    ///< added to every cell but the first
};

struct Found {
  double any_differs = 0.0;    ///< share of sweeps in which any cell is significant
  double any_misses = 0.0;     ///< share of sweeps in which any corrected interval leaves out the truth
  double single_misses = 0.0;  ///< share of the single comparisons' 95 % intervals that do
  double significant = 0.0;    ///< share of comparisons that are significant
};

Found simulate(const World& world, int trials, std::uint64_t seed) {
  const auto plan = test::plan_of({.cells = world.cells, .replicates = world.replicates, .paired = world.paired});
  const SweepGrid grid = grid_of(plan);
  const std::array names{test::hunger};
  Found found;
  for (int trial = 0; trial < trials; ++trial) {
    Rng rng{seed, Stream::user, static_cast<std::uint64_t>(trial)};
    std::vector<double> common(world.replicates);
    for (double& value : common) value = rng.normal(0.0, world.shared);
    const auto values = test::values_of_plan(plan, test::hunger, [&](const sweep::PlannedRun& run) {
      const double of_seed = world.paired ? common[run.replicate] : rng.normal(0.0, world.shared);
      const double spread = world.own * (1.0 + world.widening * static_cast<double>(run.cell));
      return of_seed + rng.normal(run.cell == 0 ? 0.0 : world.effect, spread);
    });
    const auto differences = compare_cells(grid, values, 0, names);
    const auto misses = [&](const std::optional<Interval>& interval) {
      return interval->lower > world.effect || interval->upper < world.effect;
    };
    const auto share = [&](auto&& is) {
      return static_cast<double>(std::ranges::count_if(differences.all, is)) / static_cast<double>(differences.all.size());
    };
    const double significant = share([](const CellDifference& d) { return d.difference.differs(); });
    found.significant += significant / trials;
    found.any_differs += (significant > 0.0 ? 1.0 : 0.0) / trials;
    found.any_misses += (share([&](const CellDifference& d) { return misses(d.corrected); }) > 0.0 ? 1.0 : 0.0) / trials;
    found.single_misses += share([&](const CellDifference& d) { return misses(d.difference.interval); }) / trials;
  }
  return found;
}

}  // namespace

TEST_CASE(
    "without an effect any cell differs in at most 5 % of sweeps, within 1.2 points, paired or not, of equal spreads or not") {
  constexpr int trials = 2000;
  std::uint64_t seed = 1;
  for (const bool paired : {true, false}) {
    for (const double widening : {0.0, 0.5}) {
      CAPTURE(paired);
      CAPTURE(widening);
      const Found found = simulate({.paired = paired, .widening = widening}, trials, seed++);
      CHECK(found.any_differs <= 0.062);
      CHECK(found.any_misses <= 0.062);
      CHECK(found.any_misses >= 0.015);  // not so wide that nothing could be found
      CHECK(std::abs(found.single_misses - 0.05) <= 0.01);
    }
  }
}

TEST_CASE("with an effect in every cell corrected intervals hold it in all of them, within 1.2 points of 95 % of sweeps") {
  for (const bool paired : {true, false}) {
    CAPTURE(paired);
    CHECK(simulate({.paired = paired, .effect = 3.0}, 1500, 11).any_misses <= 0.062);
  }
}

TEST_CASE("seeds that are alike are worth more in pairs, those that are not cost the pairs their degrees of freedom") {
  const World alike{.replicates = 10, .shared = 2.0, .effect = 1.6};
  World apart = alike;
  apart.paired = false;
  CHECK(simulate(alike, 150, 21).significant > simulate(apart, 150, 21).significant + 0.3);
  const World nothing_shared{.replicates = 10, .shared = 0.0, .effect = 1.6};
  World sets = nothing_shared;
  sets.paired = false;
  CHECK(simulate(nothing_shared, 200, 22).significant < simulate(sets, 200, 22).significant);
}

TEST_CASE("as many runs as are asked for find the difference in 80 % of comparisons at the corrected level") {
  constexpr double effect = 1.0;
  constexpr std::size_t cells = 6;
  const double level = 0.05 / static_cast<double>(cells - 1);
  for (const bool paired : {true, false}) {
    for (const double own : {0.5, 1.0}) {
      CAPTURE(paired);
      CAPTURE(own);
      World world{.cells = cells, .paired = paired, .own = own, .effect = effect};
      const double variance = paired ? 2.0 * own * own : 2.0 * (own * own + world.shared * world.shared);
      world.replicates = *runs_for_power(effect, {.variance = variance, .freedom = paired ? 1.0 : 2.0}, level);
      // Holm's correction finds more than one comparison at this level, where many cells differ.
      const double significant = simulate(world, 200, 31).significant;
      CHECK(significant >= 0.78);
      CHECK(significant <= 0.97);
      Rng rng{32, Stream::user};
      int found = 0;
      constexpr int trials = 3000;
      for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> a(world.replicates);
        std::vector<double> b(world.replicates);
        for (std::size_t i = 0; i < a.size(); ++i) {
          const double common = rng.normal(0.0, world.shared);
          a[i] = common + rng.normal(0.0, own);
          b[i] = (paired ? common : rng.normal(0.0, world.shared)) + rng.normal(effect, own);
        }
        const auto [of, scatter] = analysis::detail::compared({a, b}, paired);
        if (*p_value(of) <= level) ++found;
      }
      CHECK(static_cast<double>(found) / trials == doctest::Approx(0.8).epsilon(0.04));
    }
  }
}

TEST_CASE("sweep power: the smallest effect that the present runs would show -> found in 80 % of comparisons") {
  Rng rng{41, Stream::user};
  constexpr double level = 0.01;
  constexpr std::size_t runs = 9;
  constexpr int trials = 4000;
  const double effect = errors_for_power(runs - 1.0, level) / std::sqrt(static_cast<double>(runs));
  int found = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> values(runs);
    for (double& value : values) value = rng.normal(effect, 1.0);
    if (*p_value(contrast({{1.0, values}})) <= level) ++found;
  }
  CHECK(static_cast<double>(found) / trials == doctest::Approx(0.8).epsilon(0.03));
}
