// SPDX-License-Identifier: MIT
// Definitions of effect_size.hpp.
#include <tools/analysis/statistics/effect_size.hpp>

#include <cmath>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

double hedges_correction(double freedom) {
  return std::exp(std::lgamma(freedom / 2.0) - std::lgamma((freedom - 1.0) / 2.0)) / std::sqrt(freedom / 2.0);
}

std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b) {
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
