// SPDX-License-Identifier: MIT
// Differences between sets of runs, and the correction for looking at many of them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <tools/analysis/statistics/interval.hpp>
#include <tools/analysis/statistics/power.hpp>

namespace trophic::analysis {

/// A difference of sets. The interval is of this difference alone; `adjusted` is its p value corrected for all metrics that are
/// compared (Holm), and decides whether the sets differ.
struct Difference {
  std::optional<double> value = {};
  std::optional<Interval> interval = {};
  std::optional<double> p = {};
  std::optional<double> adjusted = {};
  std::optional<Scatter> scatter = {};  ///< run by run; empty if it was not asked for
  std::optional<double> level = {};     ///< that Bonferroni leaves to this one of so many comparisons; Holm finds a little more
  [[nodiscard]] bool differs() const { return adjusted && *adjusted <= 0.05; }
  /// The runs in each set with which a difference of this size is found in 80 % of studies, at `level`. Empty if it is
  /// significant, if it cannot be known, or if `most_runs` are too few.
  [[nodiscard]] std::optional<std::size_t> runs_needed() const;
};

/// As tables have it: yes or no; empty without a p value.
[[nodiscard]] std::string significance_text(const Difference& difference);

/// `value` is given by the caller, as a contrast needs more runs than a difference does.
[[nodiscard]] Difference difference_of(std::optional<double> value, const std::optional<Contrast>& of,
                                       const std::optional<Scatter>& scatter = {});

/// Holm's correction over all of `differences` together. One without a p value, in which nothing varies, is not a comparison.
void adjust_together(std::span<Difference* const> differences);

}  // namespace trophic::analysis
