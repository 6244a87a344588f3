// SPDX-License-Identifier: MIT
// Many sets of runs, each with something flipped, against the one set in which nothing is.
#pragma once

#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <tools/analysis/statistics/difference.hpp>
#include <tools/analysis/statistics/estimate.hpp>

namespace trophic::analysis {

/// The effect of a swap on one metric.
struct SwapEffect {
  std::string swap;
  MetricName name;
  bool over_shadow = false;  ///< both sets were set over their shadows before they were compared
  Estimate base;
  Estimate swapped;
  Difference difference;
};

/// Whether a metric moves with the composition of the population alone, so that only a shadow isolates the effect of inheritance.
[[nodiscard]] bool needs_shadow(const MetricName& name);

/// One effect a metric: over the shadows where the metric needs it and both sets have one, else raw. The p values are not yet
/// adjusted: `adjust_together` does it for all swaps at once.
[[nodiscard]] std::vector<SwapEffect> effects_of(const std::string& swap, std::span<const SetDifference> differences);

/// Holm's correction over all swaps and metrics of a list.
void adjust_together(std::vector<SwapEffect>& effects);

}  // namespace trophic::analysis
