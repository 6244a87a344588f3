// SPDX-License-Identifier: MIT
// What was measured in each run of a sweep: numbers alone, so that ten thousand runs fit the memory.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tools/analysis/data/read_run.hpp>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/replicates/parallel.hpp>
#include <utility>
#include <vector>

namespace trophic::analysis {

struct SweepValues {
  std::vector<MetricName> names;
  /// By planned run, then in the order of `names`; of a run that is not there nothing, of one with another food web or in which
  /// it could not be computed none.
  std::vector<std::vector<std::optional<double>>> of_run;

  [[nodiscard]] std::size_t place_of(const MetricName& name) const {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  }
  [[nodiscard]] std::optional<double> value(std::optional<std::size_t> run, std::size_t metric) const {
    return run && !of_run[*run].empty() ? of_run[*run][metric] : std::nullopt;
  }
};

/// The metrics of runs with these food webs, each once, as measure_run orders them.
[[nodiscard]] inline std::vector<MetricName> metric_names(std::span<const FoodWeb> webs) {
  std::vector<MetricName> names;
  for (const FoodWeb& web : webs) {
    RunData nothing;
    nothing.manifest.web = web;
    nothing.manifest.half_side_m = 1.0;
    for (const Measurement& measurement : measure_run(nothing).measurements) {
      if (std::ranges::find(names, measurement.name) == names.end()) names.push_back(measurement.name);
    }
  }
  return names;
}

/// Reads and measures the runs that are there, `jobs` at a time, each only for its first `until_s` seconds where given; what was
/// read of a run is gone when it is measured. The values do not depend on `jobs`. Throws std::runtime_error for the first run in
/// the plan's order that cannot be read as a whole; the others are given up.
[[nodiscard]] inline SweepValues measure_sweep(const SweepRuns& sweep, std::size_t jobs, std::optional<double> until_s = {}) {
  SweepValues values{metric_names(sweep.webs), std::vector<std::vector<std::optional<double>>>(sweep.plan.size())};
  std::atomic<bool> has_failed = false;
  const auto measure = [&](std::size_t i) {
    if (!sweep.is_there[i]) return;
    try {
      RunData run = read_run(sweep.folder_of(i));
      if (!run.remarks.empty()) throw std::runtime_error{run.remarks.front()};
      if (until_s) cut_to(run, *until_s);
      const RunMetrics measured = measure_run(run);
      std::vector<std::optional<double>> numbers(values.names.size());
      for (const Measurement& measurement : measured.measurements) numbers[values.place_of(measurement.name)] = measurement.value;
      values.of_run[i] = std::move(numbers);
    } catch (...) {
      has_failed = true;
      throw;
    }
  };
  const auto attempts = replicates::in_parallel(sweep.plan.size(), jobs, measure, [&] { return !has_failed; });
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    if (!attempts[i].error.empty()) throw std::runtime_error{"run " + std::to_string(i) + ": " + attempts[i].error};
  }
  return values;
}

/// One metric of a cell: its values by seed, and by seed how far above its shadow a run is.
struct CellValues {
  std::map<std::uint64_t, double> raw;
  std::map<std::uint64_t, double> shadow;
  std::map<std::uint64_t, double> over_shadow;  ///< where a run and its shadow have a value
};

[[nodiscard]] inline CellValues cell_values(const GridCell& cell, const SweepValues& values, std::size_t metric) {
  CellValues of;
  for (const GridReplicate& replicate : cell.replicates) {
    const auto run = values.value(replicate.run, metric);
    const auto shadow = values.value(replicate.shadow, metric);
    if (run) of.raw[replicate.seed] = *run;
    if (shadow) of.shadow[replicate.seed] = *shadow;
    if (run && shadow) of.over_shadow[replicate.seed] = *run - *shadow;
  }
  return of;
}

}  // namespace trophic::analysis
