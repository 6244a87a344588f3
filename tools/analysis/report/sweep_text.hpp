// SPDX-License-Identifier: MIT
// Results of a sweep for people: what is significant, what is not, and how many runs would decide.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/analysis/report/cell_differences.hpp>
#include <vector>

namespace trophic::analysis {

namespace detail {

/// With a noun in the plural where it is not one.
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun);

[[nodiscard]] std::string decimals(double value, int count, bool sign = false);

/// The last part of a setting's path, and the whole where two axes end alike.
[[nodiscard]] std::string axis_title(std::span<const Axis> axes, const Axis& axis);

/// "reach_m 0.5, sd 0.05".
[[nodiscard]] std::string cell_title(const SweepGrid& grid, std::size_t number);

/// The values of an axis, each once, in the order of the cells; of many the first few.
[[nodiscard]] std::string values_on(const Axis& axis);

/// The name of a metric as far as it fits a line, with what was compared.
[[nodiscard]] std::string compared_title(const CellDifference& d);

/// A metric that is significant in some cells.
struct SignificantMetric {
  const CellDifference* largest = nullptr;
  std::size_t cells = 0;
};

/// Those that are significant in most cells first.
[[nodiscard]] std::vector<SignificantMetric> significant_metrics(const CellDifferences& differences);

/// One line a metric: in how many cells it is significant, and where it differs most.
void print_significant_metrics(std::ostream& out, const SweepGrid& grid, const CellDifferences& differences);

}  // namespace detail

/// The grid, the reference cell, how many comparisons there are and how they were made.
void print_sweep(std::ostream& out, const SweepRuns& sweep, const CellDifferences& differences, std::size_t reference,
                 std::optional<double> until_s = {});

/// One line a metric that is significant anywhere, then what is not, in words.
void print_cell_differences(std::ostream& out, const SweepGrid& grid, const CellDifferences& differences);

/// One line for each metric of each cell: means, difference, p and the runs that would be needed. For few metrics.
void print_named_metrics(std::ostream& out, const SweepGrid& grid, const CellDifferences& differences);

/// One line a metric: how many replicates a difference of that size would need.
void print_runs_for_difference(std::ostream& out, std::span<const RunsForDifference> answers, const CellDifferences& of);

}  // namespace trophic::analysis
