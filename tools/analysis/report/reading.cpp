// SPDX-License-Identifier: MIT
// Definitions of reading.hpp.
#include <tools/analysis/report/reading.hpp>

namespace trophic::analysis {

namespace {

/// Shares and counts; hunger in ticks is a metric of trophic's own, whose unit the glossary gives.
bool is_plain_unit(const MetricName& name) {
  return name.unit.empty() || name.unit == "1" || name.unit == "ticks";
}

}  // namespace

std::string Reading::with_interval(const std::optional<double>& value, const std::optional<Interval>& interval, bool sign) const {
  if (!value) return "missing";
  if (!interval) return (*this)(*value, sign);
  return (*this)(*value, sign) + " [" + (*this)(interval->lower, sign) + ", " + (*this)(interval->upper, sign) + "]";
}

std::string Reading::of(const Estimate& estimate) const {
  if (estimate.interval || !estimate.deviation) return with_interval(estimate.mean, estimate.interval);
  return (*this)(estimate.mean) + " (sd " + (*this)(estimate.deviation) + ")";
}

std::string p_text(const std::optional<double>& p) {
  if (!p) return "";
  if (*p < 0.0005) return "<0.001";
  std::string text(16, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.3f", *p)));
  return text;
}

std::string runs_needed_text(const Difference& difference) {
  if (!difference.level || difference.differs()) return "";
  const auto runs = difference.runs_needed();
  return runs ? std::to_string(*runs) : "more than " + std::to_string(most_runs);
}

std::string metric_title(const MetricName& name) {
  return name.metric + (name.species.empty() ? "" : " " + name.species) +
         (name.group == "all" || name.group.empty() ? "" : " (" + name.group + ")") +
         (name.unit == "m/s"    ? ", cm/s"
          : is_plain_unit(name) ? ""
                                : ", " + name.unit);
}

}  // namespace trophic::analysis
