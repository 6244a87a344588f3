// SPDX-License-Identifier: MIT
// The measured values of each run of a sweep: numbers alone, so that ten thousand runs fit into memory.
#pragma once

#include <cstdint>
#include <map>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/analysis/metrics/run_set.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::analysis {

struct SweepValues {
  std::vector<MetricName> names;
  /// By planned run, then in the order of `names`; of a run that is not there nothing, of one with another food web or in which
  /// it could not be computed none.
  std::vector<std::vector<std::optional<double>>> of_run;
  std::vector<std::string> remarks = {};  ///< about runs in which a metric of the user has no value, in the plan's order

  [[nodiscard]] std::size_t place_of(const MetricName& name) const;
  [[nodiscard]] std::optional<double> value(std::optional<std::size_t> run, std::size_t metric) const;
};

/// The metrics of runs with these food webs, each once, as measure_run orders them.
[[nodiscard]] std::vector<MetricName> metric_names(std::span<const FoodWeb> webs, bool bodies = false);

/// Checks before anything is measured that each of the user's metrics has a name of its own, and that each choice names a metric.
/// Throws std::invalid_argument.
void check_names(std::span<const FoodWeb> webs, const Measuring& how, std::span<const std::string> choices);

/// Reads and measures the runs that are there; what was read of a run is gone when it is measured. The values do not depend on
/// `how.jobs`. Throws for the first run in the plan's order that cannot be measured, and gives up the others:
/// std::invalid_argument if it cannot be read as a whole, std::runtime_error if a metric of the user throws.
[[nodiscard]] SweepValues measure_sweep(const SweepRuns& sweep, const Measuring& how = {});

/// One metric of a cell: its values by seed, and by seed how far above its shadow a run is.
struct CellValues {
  std::map<std::uint64_t, double> raw;
  std::map<std::uint64_t, double> shadow;
  std::map<std::uint64_t, double> over_shadow;  ///< where a run and its shadow have a value
};

[[nodiscard]] CellValues cell_values(const GridCell& cell, const SweepValues& values, std::size_t metric);

}  // namespace trophic::analysis
