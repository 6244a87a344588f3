// SPDX-License-Identifier: MIT
// Definitions of measurement.hpp.
#include <tools/analysis/metrics/measurement.hpp>

#include <algorithm>

namespace trophic::analysis {

std::vector<double> values_of(std::span<const RunMetrics> runs, const MetricName& name) {
  std::vector<double> values;
  for (const RunMetrics& run : runs) {
    const auto found = std::ranges::find(run.measurements, name, &Measurement::name);
    if (found != run.measurements.end() && found->value) values.push_back(*found->value);
  }
  return values;
}

}  // namespace trophic::analysis
