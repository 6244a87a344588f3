// SPDX-License-Identifier: MIT
// Error rates of lineage measures: a thousand simulated analyses of runs in which parents are drawn by chance, and of runs with
// a planted effect.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tools/analysis/metrics/lineage_metrics.hpp>
#include <tools/analysis/report/summary.hpp>
#include <trophic/support/rng.hpp>
#include <utility>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

constexpr double run_s = 400.0;
constexpr double window_s = 50.0;
const FoodWeb one_species{{"prey"}, {}};

/// Chances of being the parent, by individual.
using Fitness = std::function<double(const Taxon&)>;

/// A population of 12 in which an individual dies by chance every 4 s, on average. A third of the newborn are random. The others
/// have a parent among the living, drawn by `fitness`, and its weights with a mutation; without heredity, random ones.
Forest simulated(std::uint64_t seed, const Fitness& fitness, bool has_heredity = true) {
  Rng rng{seed, Stream::user};
  const auto random_weights = [&] { return std::vector{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}; };
  Forest forest;
  std::vector<std::size_t> living;
  for (; living.size() < 12; living.push_back(living.size())) forest.push_back({.weights = random_weights()});
  for (double time_s = 2.0; time_s <= run_s; time_s += 2.0) {
    if (!rng.chance(0.5)) continue;
    const std::size_t place = rng.index(living.size());
    forest[living[place]].death_s = time_s;
    living.erase(living.begin() + static_cast<std::ptrdiff_t>(place));
    Taxon born{.parent = {}, .birth_s = time_s, .weights = random_weights()};
    if (!rng.chance(1.0 / 3.0)) {
      double all = 0.0;
      for (const std::size_t one : living) all += fitness(forest[one]);
      double left = rng.uniform(0.0, all);
      std::size_t chosen = 0;
      while (chosen + 1 < living.size() && left > fitness(forest[living[chosen]])) left -= fitness(forest[living[chosen++]]);
      born.parent = living[chosen];
      if (has_heredity) {
        born.weights = forest[*born.parent].weights;
        for (double& weight : born.weights) weight += rng.normal(0.0, 0.1);
      }
    }
    living.push_back(forest.size());
    forest.push_back(std::move(born));
  }
  return forest;
}

double by_chance(const Taxon&) {
  return 1.0;
}

/// The side depends on two inputs, the tag on one.
control::Decision decide(std::span<const double> inputs, std::span<const double> weights) {
  return {.target_angle_rad = weights[0] * inputs[0] + weights[1] * inputs[1], .tag = weights[2] > inputs[1] ? 1 : -1};
}

std::vector<RunMetrics> measured_runs(std::size_t runs, std::uint64_t first_seed, const Fitness& fitness,
                                      bool has_heredity = true) {
  Signatures signatures{decide, {{{1.0, 0.1}, {1.0, 0.4}, {1.0, 0.9}, {-1.0, 0.1}, {-1.0, 0.4}, {-1.0, 0.9}}}};
  std::vector<RunMetrics> all;
  for (std::uint64_t seed = first_seed; seed < first_seed + runs; ++seed) {
    all.push_back(lineage_metrics(simulated(seed, fitness, has_heredity), one_species, signatures, window_s, run_s, seed));
    all.back().curves.clear();
  }
  return all;
}

/// `size` of the runs, each once.
std::vector<RunMetrics> drawn(const std::vector<RunMetrics>& runs, std::size_t size, Rng& rng) {
  std::vector<std::size_t> order(runs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::vector<RunMetrics> sample;
  for (std::size_t i = 0; i < size; ++i) {
    std::swap(order[i], order[i + rng.index(order.size() - i)]);
    sample.push_back(runs[order[i]]);
  }
  return sample;
}

/// Share of analyses of `size` runs in which a measure differs from a null, at 5 % alone.
using Shares = std::map<std::string, double>;

std::string title_of(const SummaryRow& row, const Comparison& comparison) {
  return row.name.metric + " " + row.name.group + ", " + comparison.baseline;
}

Shares found(const std::vector<RunMetrics>& runs, const std::vector<RunMetrics>& shadows, std::size_t size, int analyses) {
  Rng rng{size, Stream::user, 1};
  Shares shares;
  for (int i = 0; i < analyses; ++i) {
    for (const SummaryRow& row : summarize(drawn(runs, size, rng), drawn(shadows, size, rng))) {
      for (const Comparison& comparison : row.comparisons) {
        const TestResult result = comparison.test_result();
        const bool differs = result == TestResult::above || result == TestResult::below;
        shares[title_of(row, comparison)] += differs ? 1.0 / analyses : 0.0;
      }
    }
  }
  return shares;
}

std::pair<std::string, double> largest_of(const Shares& shares) {
  return *std::ranges::max_element(shares, {}, &Shares::value_type::second);
}

}  // namespace

TEST_CASE("lineages: parents by chance -> at most 7 % of 1000 analyses find a difference, for every measure and null") {
  const auto shares = found(measured_runs(600, 1, by_chance), measured_runs(600, 10'001, by_chance), 10, 1000);
  const auto largest = largest_of(shares);
  MESSAGE(shares.size(), " measures and nulls; the largest: ", largest.second, " of ", largest.first);
  CHECK(shares.size() == 2 * (2 * 8 + 7));
  CHECK(largest.second <= 0.07);
}

TEST_CASE("lineages: planted effects, 30 runs -> the measure that is for it finds it in at least 80 %") {
  struct Planted {
    std::string effect;
    Fitness fitness;
    std::vector<std::string> measures;
  };
  const std::array effects{
      Planted{"ten times the chance of being a parent for one half of the types",
              [](const Taxon& one) { return one.weights[2] > 0.4 ? 10.0 : 1.0; },
              {"activity_excess late, drift"}},
      Planted{"twenty times the chance of being a parent for a quarter of the individuals, whatever their types",
              [](const Taxon& one) { return static_cast<int>(one.birth_s) % 8 == 0 ? 20.0 : 1.0; },
              {"descent_related_pairs all, drift", "descent_largest_clade all, drift"}}};
  for (const Planted& planted : effects) {
    const auto shares = found(measured_runs(200, 20'001, planted.fitness), measured_runs(60, 30'001, by_chance), 30, 100);
    for (const std::string& measure : planted.measures) {
      MESSAGE(planted.effect, ": ", measure, ": ", shares.at(measure));
      CHECK(shares.at(measure) >= 0.8);
    }
  }
}

TEST_CASE("lineages: types next to a shadow, in which nothing is inherited -> the calibration fails") {
  const auto shares = found(measured_runs(200, 1, by_chance), measured_runs(200, 40'001, by_chance, false), 10, 200);
  MESSAGE("change over the shadow: ", shares.at("modes_change late, shadow"));
  CHECK(shares.at("modes_change late, shadow") > 0.14);
  CHECK(shares.at("modes_change late, drift") <= 0.1);
}
