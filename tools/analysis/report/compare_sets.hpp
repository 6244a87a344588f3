// SPDX-License-Identifier: MIT
// Two sets of runs compared, metric by metric.
#pragma once

#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/statistics/difference.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <tools/reading/run_manifest.hpp>

namespace trophic::analysis {

/// One metric of two sets.
struct SetDifference {
  MetricName name;
  Estimate a;
  Estimate b;
  Difference raw;                          ///< b - a: moves with the population's composition, too
  Difference over_shadow;                  ///< (b - shadow of b) - (a - shadow of a); empty unless both have a shadow
  std::optional<MetricName> same_as = {};  ///< see repeated_metrics; not compared again
};

/// Throws std::invalid_argument, naming both, if runs of two sets did not last equally long, or it is not known.
void check_comparable(const RunManifest& a, const RunManifest& b);

/// For every metric that both sets measured, in the order of `a`, or for those that `choices` name (see `chosen`). p values are
/// corrected for all metrics that repeat no earlier one.
[[nodiscard]] std::vector<SetDifference> compare_sets(const ShadowedSet& a, const ShadowedSet& b,
                                                      std::span<const std::string> choices = {});

}  // namespace trophic::analysis
