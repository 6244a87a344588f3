// SPDX-License-Identifier: MIT
// A metric as people read it: its name, its values in handy units.
#pragma once

#include <cstddef>
#include <cstdio>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/statistics/difference.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

/// A value in the unit that people read: velocities in cm/s, shares with three decimals, counts with one.
class Reading {
 public:
  explicit Reading(const MetricName& name)
      : factor_{name.unit == "m/s" ? 100.0 : 1.0},
        decimals_{name.unit == "m/s"                                                               ? 2
                  : name.unit == "ticks" || name.metric == "deaths" || name.metric == "population" ? 1
                                                                                                   : 3} {}

  [[nodiscard]] std::string operator()(double value, bool sign = false) const {
    std::string text(64, '\0');
    const int length = std::snprintf(text.data(), text.size(), sign ? "%+.*f" : "%.*f", decimals_, factor_ * value);
    text.resize(static_cast<std::size_t>(length));
    return text;
  }
  [[nodiscard]] std::string operator()(const std::optional<double>& value, bool sign = false) const {
    return value ? (*this)(*value, sign) : "missing";
  }
  [[nodiscard]] std::string with_interval(const std::optional<double>& value, const std::optional<Interval>& interval,
                                          bool sign = false) const;
  /// A mean with its interval, or with the spread between runs where there are too few for one.
  [[nodiscard]] std::string of(const Estimate& estimate) const;

 private:
  double factor_;
  int decimals_;
};

/// "0.032", "<0.001"; empty without a p value.
[[nodiscard]] std::string p_text(const std::optional<double>& p);

/// "34", or "more than 1000000"; empty for a difference that is significant or could not be tested.
[[nodiscard]] std::string runs_needed_text(const Difference& difference);

/// "velocity prey (random), cm/s".
[[nodiscard]] std::string metric_title(const MetricName& name);

}  // namespace trophic::analysis
