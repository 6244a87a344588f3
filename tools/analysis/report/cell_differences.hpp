// SPDX-License-Identifier: MIT
// The cells of a sweep, metric by metric, against one of them: differences corrected for their number, how large they are, and
// how many runs they would need.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <tools/analysis/statistics/difference.hpp>
#include <tools/analysis/statistics/effect_size.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <tools/analysis/statistics/power.hpp>
#include <utility>

namespace trophic::analysis {

/// One metric of a cell compared with that of the reference cell.
struct CellDifference {
  std::size_t cell = 0;  ///< its number
  MetricName name;
  bool over_shadow = false;  ///< each run was set over its shadow before cells were compared
  bool paired = false;       ///< seed by seed; else as independent sets
  std::size_t runs = 0;      ///< of the cell, as many as were compared
  std::size_t runs_reference = 0;
  std::optional<double> mean;  ///< over these runs
  std::optional<double> mean_reference;
  Difference difference;              ///< cell - reference, with the interval of this comparison alone
  std::optional<Interval> corrected;  ///< holds the truth in all comparisons at once with 95 %
  std::optional<double> hedges_g;
  std::optional<Scatter> scatter;
  std::optional<std::size_t> runs_needed;  ///< for this difference, at the corrected level with `usual_power`
  std::optional<double> detectable;        ///< by the runs at hand, at the corrected level with `usual_power`
};

/// All comparisons of a sweep.
struct CellDifferences {
  std::vector<CellDifference> all;  ///< by cells, then metrics
  std::size_t comparisons = 0;      ///< those in which anything varies or differs: what is corrected for
  /// The level of one comparison, so that all together err in at most 5 % of analyses [dunn1961].
  [[nodiscard]] double level() const { return 0.05 / static_cast<double>(std::max<std::size_t>(1, comparisons)); }
};

namespace detail {

/// The values that two cells are compared by; pairs stand in the same places.
struct ComparedValues {
  std::vector<double> reference;
  std::vector<double> cell;
};

[[nodiscard]] ComparedValues compared_values(const std::map<std::uint64_t, double>& reference,
                                             const std::map<std::uint64_t, double>& cell, bool paired);

/// cell - reference by pairs, or by Welch, and the scatter of it.
[[nodiscard]] std::pair<std::optional<Contrast>, std::optional<Scatter>> compared(const ComparedValues& values, bool paired);

/// The difference before the correction for the number of comparisons, and its contrast.
[[nodiscard]] std::pair<CellDifference, std::optional<Contrast>> compare_values(const ComparedValues& values, bool paired);

/// False if nothing varies and nothing differs, or if there is only one run.
[[nodiscard]] bool is_comparison(const CellDifference& d);

/// Holm's correction over all comparisons. One of fewer runs than a test needs has no p value, but counts: more runs would
/// give it one.
void adjust(std::span<CellDifference> all);

}  // namespace detail

/// The metrics without those that repeat an earlier one in all runs (repeated_metrics.hpp) and are compared alike.
[[nodiscard]] std::vector<MetricName> distinct_metrics(const SweepValues& values);

/// Compares every cell with `reference` in each of `names`: over the shadows where the metric needs it and both cells have them,
/// else raw; seed by seed where the cells share seeds (the mean of the pairs' differences, Student's t), else as independent sets
/// (Welch). Throws std::invalid_argument if the grid has no such cell, or as is_paired.
[[nodiscard]] CellDifferences compare_cells(const SweepGrid& grid, const SweepValues& values, std::size_t reference,
                                            std::span<const MetricName> names);

/// How many runs in each cell a difference of a size would need in a metric, at the corrected level with `usual_power`.
struct RunsForDifference {
  MetricName name;
  double difference = 0.0;
  bool over_shadow = false;
  std::optional<std::size_t> runs;    ///< by the scatter that cells have on average
  std::optional<std::size_t> fewest;  ///< by that of the least and of the most scattered cell
  std::optional<std::size_t> most;
  std::size_t cells = 0;  ///< whose scatter is known
};

/// For each metric that was compared. A metric of unknown scatter has none.
[[nodiscard]] std::vector<RunsForDifference> runs_for_difference(const CellDifferences& differences, double difference);

}  // namespace trophic::analysis
