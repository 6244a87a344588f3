// SPDX-License-Identifier: MIT
// Tag symmetry: whether two species show opposite tags, and what tags without any meaning would give.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <trophic/measure/series.hpp>
#include <trophic/measure/tables.hpp>
#include <trophic/rng.hpp>
#include <utility>
#include <vector>

namespace trophic::measure {

/// E|mean of `a` fair coins + mean of `b` fair coins|, coins showing -1 or +1: the tag symmetry that populations of these numbers
/// have if tags mean nothing. Exact for up to 1000 coins in all, beyond that by the normal limit sqrt(2 (1/a + 1/b) / pi), whose
/// relative error is then below 1e-3. Both must be > 0.
[[nodiscard]] inline double fair_coin_symmetry(std::size_t a, std::size_t b) {
  const auto count_a = static_cast<double>(a);
  const auto count_b = static_cast<double>(b);
  if (a + b > 1000) return std::sqrt(2.0 * (1.0 / count_a + 1.0 / count_b) / std::numbers::pi);
  const auto probabilities = [](double coins) {  // of k heads, k = 0, ..., coins
    std::vector<double> probability;
    for (double k = 0.0; k <= coins; k += 1.0) {
      probability.push_back(
          std::exp(std::lgamma(coins + 1.0) - std::lgamma(k + 1.0) - std::lgamma(coins - k + 1.0) - coins * std::numbers::ln2));
    }
    return probability;
  };
  const auto of_a = probabilities(count_a);
  const auto of_b = probabilities(count_b);
  double expectation = 0.0;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    const double mean_a = 2.0 * static_cast<double>(i) / count_a - 1.0;
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      expectation += of_a[i] * of_b[j] * std::abs(mean_a + 2.0 * static_cast<double>(j) / count_b - 1.0);
    }
  }
  return expectation;
}

/// The paper's baseline: the mean of |u + v| over `pairs` pairs of numbers uniform in [-1, 1) (2/3 in the limit). Two draws per
/// pair. It stands for two infinitely large species whose mean tags can be anything, not for 30 robots.
[[nodiscard]] inline double uniform_pair_symmetry(Rng& rng, std::size_t pairs = 100'000) {
  Mean mean;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double first = rng.uniform(-1.0, 1.0);
    mean.add(std::abs(first + rng.uniform(-1.0, 1.0)));
  }
  return mean.value().value_or(0.0);
}

/// Tag symmetry of two species over a run, and of fair coins in the same numbers at the same ticks.
struct TagSymmetry {
  WindowMean observed;
  WindowMean fair_coins;
};

/// At each tick |mean tag of one species + mean tag of the other|, inherited members only (Sec. "Metrics for system dynamics");
/// ticks at which either has no inherited member are left out. Close to 0: the species show opposite tags.
[[nodiscard]] inline TagSymmetry tag_symmetry(Agents agents, Species a, Species b, double window_s = 200.0) {
  TagSymmetry symmetry{WindowMean{window_s}, WindowMean{window_s}};
  std::map<std::pair<std::size_t, std::size_t>, double> expected;
  for (const Agents& now : by_tick(agents)) {
    Mean tag_a;
    Mean tag_b;
    std::size_t count_a = 0;
    std::size_t count_b = 0;
    for (const AgentRow& row : now) {
      if (row.origin != Origin::inherited) continue;
      if (row.species == a) {
        tag_a.add(row.tag);
        ++count_a;
      } else if (row.species == b) {
        tag_b.add(row.tag);
        ++count_b;
      }
    }
    if (count_a == 0 || count_b == 0) continue;
    const auto [entry, is_new] = expected.try_emplace({count_a, count_b});
    if (is_new) entry->second = fair_coin_symmetry(count_a, count_b);
    symmetry.observed.add(now.front().time_s, std::abs(*tag_a.value() + *tag_b.value()));
    symmetry.fair_coins.add(now.front().time_s, entry->second);
  }
  return symmetry;
}

}  // namespace trophic::measure
