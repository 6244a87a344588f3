// SPDX-License-Identifier: MIT
// Definitions of published.hpp.
#include <tools/analysis/report/published.hpp>

namespace trophic::analysis {

MetricName metric_of(const ClaimReading& reading) {
  const std::string_view unit = reading.metric.starts_with("velocity") ? "m/s" : "1";
  return {std::string{reading.metric}, std::string{reading.species}, std::string{reading.group}, std::string{unit}};
}

std::optional<double> published(const MetricName& name) {
  for (const Claim& claim : claims) {
    for (const ClaimReading& reading : claim.readings) {
      const bool is_recount = reading.source == Source::logs && claim.readings.front().source == Source::text;
      if (metric_of(reading) == name && !is_recount) return reading.value;
    }
  }
  return std::nullopt;
}

}  // namespace trophic::analysis
