// SPDX-License-Identifier: MIT
// Definitions of reading.hpp.
#include <tools/analysis/report/reading.hpp>

namespace trophic::analysis {

std::string Reading::with_interval(const std::optional<double>& value, const std::optional<Interval>& interval, bool sign) const {
  if (!value) return "missing";
  if (!interval) return (*this)(*value, sign);
  return (*this)(*value, sign) + " [" + (*this)(interval->lower, sign) + ", " + (*this)(interval->upper, sign) + "]";
}

std::string Reading::of(const Estimate& estimate) const {
  if (estimate.interval || !estimate.deviation) return with_interval(estimate.mean, estimate.interval);
  return (*this)(estimate.mean) + " (sd " + (*this)(estimate.deviation) + ")";
}

std::string metric_title(const MetricName& name) {
  return name.metric + " " + name.species + (name.group == "all" ? "" : " (" + name.group + ")") +
         (name.unit == "m/s" ? ", cm/s" : "");
}

}  // namespace trophic::analysis
