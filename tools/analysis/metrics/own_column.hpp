// SPDX-License-Identifier: MIT
// Metrics of one's own: the mean of a column of a table that each run's folder has.
#pragma once

#include <tools/analysis/metrics/measurement.hpp>
#include <tools/reading/read_run.hpp>

namespace trophic::analysis {

/// A column of a CSV table in a run's folder. Rows with one species and group are one metric; a table without these columns is
/// one of all. Empty cells and nan are ticks without a value. With a column time_s there is a curve, and --until applies.
struct OwnColumn {
  std::string file;
  std::string column;
  std::string unit = "1";
};

/// Reads "FILE:COLUMN" or "FILE:COLUMN:UNIT". Throws std::invalid_argument, naming the option, for anything else.
[[nodiscard]] OwnColumn own_column_of(std::string_view text);

/// Adds the column's means over the run, in the order in which they come in the table, and its curves in windows of 200 s. A run
/// in which there is no value gets a remark. Throws std::invalid_argument for a run without the file, and std::runtime_error
/// "FILE:LINE: ..." for a cell that is not a number and for a file without the column.
void measure_column(const OwnColumn& column, const RunData& run, RunMetrics& result, std::vector<std::string>& remarks);

/// Runs that lack a species or group of a column that another run has get it without a value, so that all measure the same.
void give_all_the_same_columns(std::span<RunMetrics* const> runs);

}  // namespace trophic::analysis
