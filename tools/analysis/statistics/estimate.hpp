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

/// Position of the interval of a difference: all of it on one side of zero, or not. `unknown`: too few runs for an interval.
/// `not_significant` does not show that there is no difference.
enum class TestResult { unknown, below, not_significant, above };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(TestResult) {
  return {"not tested", "below", "not significant", "above"};
}
[[nodiscard]] constexpr TestResult test_result(const std::optional<Interval>& difference) {
  if (!difference) return TestResult::unknown;
  if (difference->lower > 0.0) return TestResult::above;
  return difference->upper < 0.0 ? TestResult::below : TestResult::not_significant;
}

/// A mean over runs, their spread and, from `min_runs_for_test` runs on, the mean's 95 % interval.
struct Estimate {
  std::size_t runs = 0;  ///< those in which it could be computed
  std::optional<double> mean;
  std::optional<double> deviation;  ///< between runs
  std::optional<Interval> interval;
};

[[nodiscard]] Estimate estimate(std::span<const double> values);

}  // namespace trophic::analysis
