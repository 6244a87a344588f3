// SPDX-License-Identifier: MIT
// Own metrics: functions of a run's tables that a program gives to its command `analyze`.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <trophic/io/tables.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::io {

/// A run as an own metric reads it. With --until the tables end at that time.
struct RunTables {
  std::span<const EventRow> events;  ///< in the order in which they happened
  std::span<const AgentRow> agents;  ///< sorted by tick
  const FoodWeb& web;
  double half_side_m = 0.0;  ///< of the arena
  double until_s = 0.0;
  std::filesystem::path folder;  ///< for files that are not in the tables, such as an own table
};

/// A value that a metric has in a run; its mean over the run is tested. NaN is a value that cannot be computed.
struct Sample {
  double value = 0.0;
  std::optional<double> time_s = {};  ///< in [0, until_s]; samples with a time also make a curve
  std::optional<Species> species = {};
  std::string group = "all";
};

/// A metric of a program. Its samples with one species and group are one measurement, with interval, shadow, correction and
/// figure.
struct OwnMetric {
  std::string name;
  std::string unit = "1";
  std::function<std::vector<Sample>(const RunTables&)> samples;  ///< called by several threads at a time
};
using OwnMetrics = std::vector<OwnMetric>;

}  // namespace trophic::io
