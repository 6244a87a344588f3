// SPDX-License-Identifier: MIT
// The measurements of a run, each value with its baselines.
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tools/analysis/metrics/series.hpp>
#include <vector>

namespace trophic::analysis {

/// The meaning of a measurement.
struct MetricName {
  std::string metric;
  std::string species;  ///< "prey"; of a metric of two: "prey+predator"
  std::string group;    ///< all, random, inherited, active, inherited_active; of deaths a cause, of ticks_at a number of members
  std::string unit;     ///< "1" for shares
  friend auto operator<=>(const MetricName&, const MetricName&) = default;
};

/// The purpose of a baseline. Only a null, the value that chance alone would give, is tested against.
enum class Role { reference, paper, null };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(Role) {
  return {"reference", "paper", "null"};
}

/// A value to compare a measurement with. `paper`: the baseline that the paper compares with.
struct Baseline {
  std::string name;
  Role role = Role::reference;
  std::optional<double> value;
};

/// One number of one run; none where it cannot be computed.
struct Measurement {
  MetricName name;
  std::optional<double> value;
  std::vector<Baseline> baselines;
};

/// A curve over the time of one run; `baseline` is empty for what was observed.
struct Curve {
  MetricName name;
  std::string baseline;
  Series points;
};

struct RunMetrics {
  std::vector<Measurement> measurements;
  std::vector<Curve> curves;
};

/// The values of a metric; runs without one are left out.
[[nodiscard]] std::vector<double> values_of(std::span<const RunMetrics> runs, const MetricName& name);

}  // namespace trophic::analysis
