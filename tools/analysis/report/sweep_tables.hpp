// SPDX-License-Identifier: MIT
// Results of a sweep for machines, written: cells.csv, runs.csv, sweep_metrics.csv, sweep_differences.csv.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <tools/analysis/report/cell_differences.hpp>
#include <tools/analysis/report/sweep_rows.hpp>

namespace trophic::analysis {

namespace detail {

[[nodiscard]] std::vector<double> numbers(const std::map<std::uint64_t, double>& by_seed);

[[nodiscard]] SweepMetricRow metric_row(std::size_t cell, const MetricName& name, const CellValues& values);

/// How many of a cell's runs, or of its shadow's, are there.
[[nodiscard]] std::size_t runs_there(const SweepRuns& sweep, const GridCell& cell,
                                     std::optional<std::size_t> GridReplicate::*kind);

}  // namespace detail

/// Writes cells.csv. `until_s`: as in measure_sweep. Throws std::runtime_error if it exists or cannot be written.
void write_cells(const std::filesystem::path& path, const SweepRuns& sweep, std::optional<double> until_s = {});

/// Writes runs.csv. Errors as write_cells.
void write_runs(const std::filesystem::path& path, const SweepRuns& sweep, const SweepValues& values);

/// Writes sweep_metrics.csv. Errors as write_cells.
void write_sweep_metrics(const std::filesystem::path& path, const SweepGrid& grid, const SweepValues& values);

/// Writes sweep_differences.csv. Errors as write_cells.
void write_sweep_differences(const std::filesystem::path& path, const CellDifferences& differences, std::size_t reference);

}  // namespace trophic::analysis
