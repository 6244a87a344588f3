// SPDX-License-Identifier: MIT
// How large a difference is beside the spread between runs.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

/// What the standardised difference of two samples is multiplied by so that it is right on average [hedges1981]; about
/// 1 - 3 / (4 freedom - 1). `freedom` > 1: of the spread that it is divided by.
[[nodiscard]] inline double hedges_correction(double freedom) {
  return std::exp(std::lgamma(freedom / 2.0) - std::lgamma((freedom - 1.0) / 2.0)) / std::sqrt(freedom / 2.0);
}

/// Hedges' g [hedges1981]: mean(b) - mean(a) over the pooled spread between runs of both sets, corrected for the number of runs.
/// Sets that are compared run by run are taken as if they were independent, so that paired and unpaired sweeps have the same
/// measure: it says how far apart runs are, not how sure the difference is. None of fewer than two runs in a set, or without any
/// spread.
[[nodiscard]] inline std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b) {
  if (a.size() < 2 || b.size() < 2) return std::nullopt;
  const auto freedom_a = static_cast<double>(a.size() - 1);
  const auto freedom_b = static_cast<double>(b.size() - 1);
  const double squares = freedom_a * std::pow(*deviation_of(a), 2.0) + freedom_b * std::pow(*deviation_of(b), 2.0);
  const double spread = std::sqrt(squares / (freedom_a + freedom_b));
  const double difference = *mean_of(b) - *mean_of(a);
  if (is_rounding(spread, difference)) return std::nullopt;
  return hedges_correction(freedom_a + freedom_b) * difference / spread;
}

}  // namespace trophic::analysis
