// SPDX-License-Identifier: MIT
// Metrics of a user's program, measured.
#pragma once

#include <tools/analysis/metrics/measurement.hpp>
#include <tools/reading/read_run.hpp>
#include <trophic/experiment/own_metric.hpp>

namespace trophic::analysis {

using io::OwnMetric;
using io::OwnMetrics;

/// Throws std::invalid_argument "metric NAME: ..." for a name or unit that is not a word of letters, digits, '_' and, of a unit,
/// of ". / ^ % -"; for a name that is one of `taken` or is there twice; and for a metric without a function.
void check_own_metrics(std::span<const OwnMetric> metrics, std::span<const std::string> taken);

/// Adds the metric's means over the run and its curves. A run in which it has no value gets a remark. Throws std::runtime_error
/// "metric NAME: FOLDER: ...", if the function throws, or returns infinity, a time outside the run, or a species that is not
/// there.
void measure_own(const OwnMetric& metric, const RunData& run, RunMetrics& result, std::vector<std::string>& remarks);

}  // namespace trophic::analysis
