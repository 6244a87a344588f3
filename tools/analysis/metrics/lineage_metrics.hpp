// SPDX-License-Identifier: MIT
// Lineage measures of a run, each with the same measure under drift.
#pragma once

#include <functional>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/reading/lineages.hpp>
#include <tools/reading/met_inputs.hpp>
#include <tools/reading/signatures.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::analysis {

/// The name of the null that drift_of makes.
inline constexpr const char* drift_name = "drift";

/// How lineages are measured.
struct LineageMeasuring {
  std::function<Decide(const RunManifest& run)> decide;  ///< the brain of a run's rule table
  std::vector<std::vector<Inputs>> inputs;               ///< of the signatures, by species
  double window_s = 500.0;                               ///< see lineage_metrics
};

/// Different inputs that a signature has.
inline constexpr std::size_t signature_inputs = 24;

/// The window for runs of this length, if none is named: 500 s, or a quarter of a shorter run.
[[nodiscard]] double default_window_s(double run_s);

/// Throws std::invalid_argument unless a run of this length has four windows.
void check_window(double window_s, double run_s);

/// The measures of each species of a forest, at the ends of windows of `window_s` up to `end_s`: MODES and activity as means over
/// the early and the late half of the run, descent as means over the whole run, all as curves. `drift` is their mean in forests
/// that drift_of makes with the seed.
[[nodiscard]] RunMetrics lineage_metrics(const Forest& forest, const FoodWeb& web, Signatures& signatures, double window_s,
                                         double end_s, std::uint64_t seed);

/// Reads and measures a run. Throws as read_lineages, and std::invalid_argument for genomes that the brain does not take.
[[nodiscard]] RunMetrics measure_lineages(const RunManifest& run, const LineageMeasuring& how);

/// Their names, in the order of the measurements.
[[nodiscard]] std::vector<MetricName> lineage_metric_names(const FoodWeb& web);

}  // namespace trophic::analysis
