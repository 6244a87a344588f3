// SPDX-License-Identifier: MIT
// Definitions of interval.hpp.
#include <tools/analysis/statistics/interval.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tools/analysis/statistics/student_t.hpp>

namespace trophic::analysis {

std::optional<double> lower_of(const std::optional<Interval>& interval) {
  return interval ? std::optional{interval->lower} : std::nullopt;
}

std::optional<double> upper_of(const std::optional<Interval>& interval) {
  return interval ? std::optional{interval->upper} : std::nullopt;
}

std::optional<double> mean_of(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> deviation_of(std::span<const double> values) {
  if (values.size() < 2) return std::nullopt;
  const double mean = *mean_of(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

bool is_rounding(double spread, double value) {
  constexpr double smallest = 1e-14;
  return spread <= smallest * std::max(1.0, std::abs(value));
}

std::optional<Contrast> contrast(std::initializer_list<Term> terms) {
  Contrast sum;
  double variance = 0.0;
  double squares = 0.0;
  for (const auto& [weight, values] : terms) {
    if (values.size() < min_runs_for_test) return std::nullopt;
    const auto count = static_cast<double>(values.size());
    const double part = weight * weight * std::pow(*deviation_of(values), 2.0) / count;
    sum.value += weight * *mean_of(values);
    variance += part;
    squares += part * part / (count - 1.0);
  }
  if (is_rounding(std::sqrt(variance), sum.value)) return Contrast{sum.value, 0.0, 1.0};
  return Contrast{sum.value, std::sqrt(variance), variance * variance / squares};
}

std::optional<Interval> interval_of(const std::optional<Contrast>& of, double level) {
  if (!of) return std::nullopt;
  if (of->error == 0.0) return Interval{of->value, of->value};
  const double half = of->error * student_t_quantile((1.0 + level) / 2.0, of->freedom);
  return Interval{of->value - half, of->value + half};
}

std::optional<double> p_value(const std::optional<Contrast>& of, double from) {
  if (!of || (of->error == 0.0 && of->value == from)) return std::nullopt;
  if (of->error == 0.0) return 0.0;
  const double t = std::abs(of->value - from) / of->error;
  return student_t_two_sided(t, of->freedom);
}

std::optional<Interval> interval_of_mean(std::span<const double> values, double level) {
  return interval_of(contrast({{1.0, values}}), level);
}

std::optional<Interval> interval_of_difference(std::span<const double> a, std::span<const double> b, double level) {
  return interval_of(contrast({{-1.0, a}, {1.0, b}}), level);
}

}  // namespace trophic::analysis
