// SPDX-License-Identifier: MIT
// A mean over runs with its spread and interval, and on which side of zero an interval lies.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

/// Where the interval of a difference lies: all of it on one side of zero, or not. `unknown`: too few runs for an interval. Not
/// distinguishable is no finding of absence.
enum class Verdict { unknown, below, not_distinguishable, above };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(Verdict) {
  return {"no verdict", "below", "not distinguishable", "above"};
}
[[nodiscard]] constexpr Verdict verdict(const std::optional<Interval>& difference) {
  if (!difference) return Verdict::unknown;
  if (difference->lower > 0.0) return Verdict::above;
  return difference->upper < 0.0 ? Verdict::below : Verdict::not_distinguishable;
}

/// A mean over runs, their spread and, from `runs_for_verdict` runs on, the mean's 95 % interval.
struct Estimate {
  std::size_t runs = 0;  ///< those in which it could be computed
  std::optional<double> mean;
  std::optional<double> deviation;  ///< between runs
  std::optional<Interval> interval;
};

[[nodiscard]] Estimate estimate(std::span<const double> values);

}  // namespace trophic::analysis
