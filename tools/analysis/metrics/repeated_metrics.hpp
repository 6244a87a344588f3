// SPDX-License-Identifier: MIT
// Metrics that say the same thing twice in some runs, such as a species without inactive members "active" and "all".
#pragma once

#include <tools/analysis/metrics/measurement.hpp>

namespace trophic::analysis {

/// For each of `names` the first earlier one that it repeats. velocity_points and velocity_stored are other readings of velocity.
/// Otherwise, in every run of every set both have a value, or neither, and either their difference or their sum is the same in
/// all runs: their tests are then one test. Empty for a metric that repeats none, is constant, or has fewer than six values, of
/// which two may agree by chance.
[[nodiscard]] std::vector<std::optional<MetricName>> repeated_metrics(std::span<const std::span<const RunMetrics>> sets,
                                                                      std::span<const MetricName> names);

/// The same for values by name: of each, one a run.
[[nodiscard]] std::vector<std::optional<MetricName>> repeated_values(std::span<const std::vector<std::optional<double>>> values,
                                                                     std::span<const MetricName> names);

}  // namespace trophic::analysis
