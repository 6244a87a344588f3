// SPDX-License-Identifier: MIT
// Error rates of lineage measures: a thousand simulated analyses of runs in which parents are drawn by chance, and of runs with
// a planted effect.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tools/analysis/metrics/lineage_metrics.hpp>
#include <tools/analysis/report/summary.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

constexpr double run_s = 400.0;
constexpr double window_s = 50.0;
const FoodWeb one_species{{"prey"}, {}};

/// The living, by place in the forest, in the order of their births.
using Living = std::vector<std::size_t>;

/// The chance of being the parent, next to those of the others who live, for the individual at a place.
using Fitness = std::function<double(const Forest&, const Living&, std::size_t place)>;

/// A population of 12 in which an individual dies by chance every 4 s, on average. A third of the newborn are random. The others
/// have a parent among the living, drawn by `fitness`, and its weights with a mutation; without heredity, random ones.
Forest simulated(std::uint64_t seed, const Fitness& fitness, bool has_heredity = true) {
  Rng rng{seed, Stream::user};
  const auto random_weights = [&] { return std::vector{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}; };
  Forest forest;
  Living living;
  for (; living.size() < 12; living.push_back(living.size())) forest.push_back({.weights = random_weights()});
  for (double time_s = 2.0; time_s <= run_s; time_s += 2.0) {
    if (!rng.chance(0.5)) continue;
    const std::size_t place = rng.index(living.size());
    forest[living[place]].death_s = time_s;
    living.erase(living.begin() + static_cast<std::ptrdiff_t>(place));
    Taxon born{.parent = {}, .birth_s = time_s, .weights = random_weights()};
    if (!rng.chance(1.0 / 3.0)) {
      double all = 0.0;
      for (const std::size_t one : living) all += fitness(forest, living, one);
      double left = rng.uniform(0.0, all);
      std::size_t chosen = 0;
      while (chosen + 1 < living.size() && left > fitness(forest, living, living[chosen])) {
        left -= fitness(forest, living, living[chosen++]);
      }
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

double by_chance(const Forest&, const Living&, std::size_t) {
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

/// Shares of analyses of `size` runs in which a measure is above and below a null, each test at 5 % alone.
struct Share {
  double above = 0.0;
  double below = 0.0;
  [[nodiscard]] double either() const { return above + below; }
};
using Shares = std::map<std::string, Share>;

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
        Share& share = shares[title_of(row, comparison)];
        share.above += result == TestResult::above ? 1.0 / analyses : 0.0;
        share.below += result == TestResult::below ? 1.0 / analyses : 0.0;
      }
    }
  }
  return shares;
}

/// The pairs of an input and an output on which the decision depends, as decide() has them, from 1 to 3.
int dependences(const Taxon& taxon) {
  const double tag = taxon.weights[2];
  return 1 + (tag > 0.1 && tag <= 0.9 ? 1 : 0) + (std::abs(taxon.weights[0]) < 0.9 * std::abs(taxon.weights[1]) ? 1 : 0);
}

/// Those who live and decide about as this one does: to the same side at a small second input, with the tag of the same inputs.
std::ptrdiff_t alike(const Forest& forest, const Living& living, std::size_t place) {
  const auto kind = [&](std::size_t one) {
    const std::vector<double>& weights = forest[one].weights;
    const int thresholds = (weights[2] > 0.1 ? 1 : 0) + (weights[2] > 0.4 ? 1 : 0) + (weights[2] > 0.9 ? 1 : 0);
    return 4 * ((weights[0] > 0.0 ? 1 : 0) + (std::abs(weights[0]) > std::abs(weights[1]) ? 2 : 0)) + thresholds;
  };
  return std::ranges::count_if(living, [&](std::size_t one) { return kind(one) == kind(place); });
}

/// How many of the living were born before this one.
std::ptrdiff_t older(const Living& living, std::size_t place) {
  return std::ranges::find(living, place) - living.begin();
}

}  // namespace

TEST_CASE("lineages: parents by chance -> at most 7 % of 1000 analyses find a difference, for every measure and null") {
  const auto shares = found(measured_runs(600, 1, by_chance), measured_runs(600, 10'001, by_chance), 10, 1000);
  const auto& [title, largest] = *std::ranges::max_element(shares, {}, [](const auto& one) { return one.second.either(); });
  MESSAGE(shares.size(), " measures and nulls; the largest: ", largest.either(), " of ", title);
  CHECK(shares.size() == 2 * (2 * 8 + 7));
  CHECK(largest.either() <= 0.07);
}

TEST_CASE("lineages: planted effects, 30 runs -> each measure finds the one that is for it in at least 80 % of analyses") {
  struct Planted {
    std::string effect;
    Fitness fitness;
    std::vector<std::string> above;
    std::vector<std::string> below;
  };
  const std::vector<std::string> diversities{"modes_change early, drift",       "modes_change late, drift",
                                             "modes_novelty early, drift",      "modes_novelty late, drift",
                                             "modes_ecology early, drift",      "modes_ecology late, drift",
                                             "activity_diversity early, drift", "activity_diversity late, drift"};
  const std::array effects{
      Planted{"ten times the chance for one half of the types",
              [](const Forest& forest, const Living&, std::size_t one) { return forest[one].weights[2] > 0.4 ? 10.0 : 1.0; },
              {"activity_excess early, drift", "activity_excess late, drift"},
              {}},
      Planted{"fifty times the chance for a quarter of the types",
              [](const Forest& forest, const Living&, std::size_t one) { return forest[one].weights[0] > 0.5 ? 50.0 : 1.0; },
              {"activity_mean early, drift", "activity_mean late, drift"},
              diversities},
      Planted{"twenty times the chance for the most complex",
              [](const Forest& forest, const Living&, std::size_t one) { return dependences(forest[one]) == 3 ? 20.0 : 1.0; },
              {"modes_complexity early, drift", "modes_complexity late, drift", "modes_complexity early, shadow",
               "modes_complexity late, shadow"},
              {"activity_new late, drift"}},
      Planted{"the same, and twenty times for the only one of its type",
              [](const Forest& forest, const Living& living, std::size_t one) {
                return (dependences(forest[one]) == 3 ? 20.0 : 1.0) * (alike(forest, living, one) == 1 ? 20.0 : 1.0);
              },
              diversities,
              {}},
      Planted{"twenty times the chance for a quarter of the individuals, whatever their types",
              [](const Forest& forest, const Living&, std::size_t one) {
                return static_cast<int>(forest[one].birth_s) % 8 == 0 ? 20.0 : 1.0;
              },
              {"descent_related_pairs all, shadow", "descent_largest_clade all, shadow", "descent_related_pairs all, drift",
               "descent_largest_clade all, drift"},
              {"descent_roots all, drift"}},
      Planted{"twenty times the chance for the youngest three",
              [](const Forest&, const Living& living, std::size_t one) {
                return older(living, one) + 3 >= std::ssize(living) ? 20.0 : 1.0;
              },
              {"descent_mean_depth all, shadow", "descent_greatest_depth all, shadow"},
              {"descent_common_ancestor all, shadow", "descent_diversity all, shadow"}}};
  const std::vector<RunMetrics> shadows = measured_runs(100, 30'001, by_chance);
  for (const Planted& planted : effects) {
    const auto shares = found(measured_runs(80, 20'001, planted.fitness), shadows, 30, 100);
    for (const bool is_above : {true, false}) {
      for (const std::string& measure : is_above ? planted.above : planted.below) {
        const double share = is_above ? shares.at(measure).above : shares.at(measure).below;
        MESSAGE(planted.effect, ": ", measure, is_above ? ", above: " : ", below: ", share);
        CHECK(share >= 0.8);
      }
    }
  }
}

TEST_CASE("lineages: types next to a shadow, in which nothing is inherited -> the calibration fails") {
  const auto shares = found(measured_runs(200, 1, by_chance), measured_runs(200, 40'001, by_chance, false), 10, 200);
  MESSAGE("change over the shadow: ", shares.at("modes_change late, shadow").either());
  CHECK(shares.at("modes_change late, shadow").either() > 0.14);
  CHECK(shares.at("modes_change late, drift").either() <= 0.1);
}
