// SPDX-License-Identifier: MIT
// Differences between sets of runs, and the correction for looking at many of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

/// A difference of sets. The interval is of this difference alone; `adjusted` is its p value corrected for all metrics that are
/// compared (Holm), and decides whether the sets differ.
struct Difference {
  std::optional<double> value;
  std::optional<Interval> interval;
  std::optional<double> p;
  std::optional<double> adjusted;
  [[nodiscard]] bool differs() const { return adjusted && *adjusted <= 0.05; }
};

/// As tables have it: yes or no; empty without a p value.
[[nodiscard]] std::string significance_text(const Difference& difference);

/// `value` is given by the caller, as a contrast needs more runs than a difference does.
[[nodiscard]] Difference difference_of(std::optional<double> value, const std::optional<Contrast>& of);

/// Holm's correction over all of `differences` together. One without a p value, in which nothing varies, is no comparison.
void adjust_together(std::span<Difference* const> differences);

}  // namespace trophic::analysis
