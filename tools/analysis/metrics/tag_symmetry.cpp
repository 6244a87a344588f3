// SPDX-License-Identifier: MIT
// Definitions of tag_symmetry.hpp.
#include <tools/analysis/metrics/tag_symmetry.hpp>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace trophic::analysis {

double bernoulli_symmetry(std::size_t a, std::size_t b) {
  if (a > b) std::swap(a, b);
  const auto count_a = static_cast<double>(a);
  const auto count_b = static_cast<double>(b);
  const bool is_large = a + b > 1000;
  if (is_large && a >= 250) return std::sqrt(2.0 * (1.0 / count_a + 1.0 / count_b) / std::numbers::pi);
  const auto probabilities = [](double coins) {  // of k heads, k = 0, ..., coins
    std::vector<double> probability;
    for (double k = 0.0; k <= coins; k += 1.0) {
      probability.push_back(
          std::exp(std::lgamma(coins + 1.0) - std::lgamma(k + 1.0) - std::lgamma(coins - k + 1.0) - coins * std::numbers::ln2));
    }
    return probability;
  };
  const auto of_a = probabilities(count_a);
  double expectation = 0.0;
  if (is_large) {
    const double deviation = std::sqrt(1.0 / count_b);
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      const double z = (2.0 * static_cast<double>(i) / count_a - 1.0) / deviation;
      const double folded = std::sqrt(2.0 / std::numbers::pi) * std::exp(-0.5 * z * z) + z * std::erf(z / std::numbers::sqrt2);
      expectation += of_a[i] * deviation * folded;
    }
    return expectation;
  }
  const auto of_b = probabilities(count_b);
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    const double mean_a = 2.0 * static_cast<double>(i) / count_a - 1.0;
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      expectation += of_a[i] * of_b[j] * std::abs(mean_a + 2.0 * static_cast<double>(j) / count_b - 1.0);
    }
  }
  return expectation;
}

double uniform_pair_symmetry(Rng& rng, std::size_t pairs) {
  Mean mean;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double first = rng.uniform(-1.0, 1.0);
    mean.add(std::abs(first + rng.uniform(-1.0, 1.0)));
  }
  return mean.value().value_or(0.0);
}

double permuted_symmetry(std::size_t a, std::size_t b, std::size_t plus) {
  const auto log_choose = [](std::size_t n, std::size_t k) {
    return std::lgamma(static_cast<double>(n) + 1.0) - std::lgamma(static_cast<double>(k) + 1.0) -
           std::lgamma(static_cast<double>(n - k) + 1.0);
  };
  const auto mean_tag = [](std::size_t positive, std::size_t all) {
    return 2.0 * static_cast<double>(positive) / static_cast<double>(all) - 1.0;
  };
  double expectation = 0.0;
  for (std::size_t in_a = plus > b ? plus - b : 0; in_a <= std::min(a, plus); ++in_a) {
    const double probability = std::exp(log_choose(a, in_a) + log_choose(b, plus - in_a) - log_choose(a + b, plus));
    expectation += probability * std::abs(mean_tag(in_a, a) + mean_tag(plus - in_a, b));
  }
  return expectation;
}

TagSymmetry tag_symmetry(Agents agents, Species a, Species b, Group group, double window_s) {
  struct Count {
    std::size_t all = 0;
    std::size_t plus = 0;
    void add(int tag) {
      ++all;
      if (tag > 0) ++plus;
    }
    [[nodiscard]] double mean() const { return 2.0 * static_cast<double>(plus) / static_cast<double>(all) - 1.0; }
  };
  TagSymmetry symmetry{WindowMean{window_s}, WindowMean{window_s}, WindowMean{window_s}};
  std::map<std::pair<std::size_t, std::size_t>, double> coins;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, double> deals;
  for (const Agents& now : by_tick(agents)) {
    Count in_a;
    Count in_b;
    for (const AgentRow& row : now) {
      if (!belongs(row, group)) continue;
      if (row.species == a) in_a.add(row.tag);
      if (row.species == b) in_b.add(row.tag);
    }
    if (in_a.all == 0 || in_b.all == 0) continue;
    const auto [coin, new_coin] = coins.try_emplace({in_a.all, in_b.all});
    if (new_coin) coin->second = bernoulli_symmetry(in_a.all, in_b.all);
    const auto [deal, new_deal] = deals.try_emplace({in_a.all, in_b.all, in_a.plus + in_b.plus});
    if (new_deal) deal->second = permuted_symmetry(in_a.all, in_b.all, in_a.plus + in_b.plus);
    const double time_s = now.front().time_s;
    symmetry.observed.add(time_s, std::abs(in_a.mean() + in_b.mean()));
    symmetry.permuted.add(time_s, deal->second);
    symmetry.bernoulli_tags.add(time_s, coin->second);
  }
  return symmetry;
}

}  // namespace trophic::analysis
