// SPDX-License-Identifier: MIT
// Bootstrap intervals over replicates.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <trophic/params.hpp>
#include <trophic/rng.hpp>
#include <tuple>
#include <vector>

namespace trophic::measure {

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

struct Bootstrap {
  std::size_t resamples = 10'000;
  double level = 0.95;
  std::uint64_t seed = 1;

  static constexpr auto fields() {
    return std::tuple{field("resamples", &Bootstrap::resamples, between(1, 1e9)),
                      field("level", &Bootstrap::level, above_to(0.0, 1.0)), field("seed", &Bootstrap::seed, at_least(0))};
  }
};

/// The plain mean; none of nothing.
[[nodiscard]] inline std::optional<double> mean_of(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The value below which a share of the sorted values lies, linear in between. `sorted` is not empty.
[[nodiscard]] inline double quantile(std::span<const double> sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

namespace detail {

inline double resampled_mean(std::span<const double> values, Rng& rng) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += values[rng.index(values.size())];
  return sum / static_cast<double>(values.size());
}

template <class Statistic>
[[nodiscard]] Interval bootstrap(const Bootstrap& how, Statistic&& statistic) {
  Rng rng{how.seed, Stream::bootstrap};
  std::vector<double> statistics(how.resamples);
  for (double& value : statistics) value = statistic(rng);
  std::ranges::sort(statistics);
  return {quantile(statistics, (1.0 - how.level) / 2.0), quantile(statistics, (1.0 + how.level) / 2.0)};
}

}  // namespace detail

/// Percentile interval of the mean: replicates drawn with replacement (Efron 1979). None for fewer than two values. With ten
/// replicates it is somewhat too narrow (a 95 % interval covers about 90 %). Draws: resamples x values.
[[nodiscard]] inline std::optional<Interval> bootstrap_mean(std::span<const double> values, const Bootstrap& how = {}) {
  if (values.size() < 2) return std::nullopt;
  return detail::bootstrap(how, [&](Rng& rng) { return detail::resampled_mean(values, rng); });
}

/// Percentile interval of mean(b) - mean(a), both sets drawn independently. None unless each has at least two values.
[[nodiscard]] inline std::optional<Interval> bootstrap_difference(std::span<const double> a, std::span<const double> b,
                                                                  const Bootstrap& how = {}) {
  if (a.size() < 2 || b.size() < 2) return std::nullopt;
  return detail::bootstrap(how, [&](Rng& rng) {
    const double mean_a = detail::resampled_mean(a, rng);
    return detail::resampled_mean(b, rng) - mean_a;
  });
}

}  // namespace trophic::measure
