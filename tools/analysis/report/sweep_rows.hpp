// SPDX-License-Identifier: MIT
// The rows of a sweep's tables: cells.csv, runs.csv, sweep_metrics.csv, sweep_differences.csv.
#pragma once

#include <cstdint>
#include <tools/analysis/report/cell_differences.hpp>
#include <trophic/io/column.hpp>

namespace trophic::analysis {

/// cells.csv: one row a cell; behind these columns stands one for each setting that varies.
struct CellRow {
  std::size_t cell = 0;
  std::string rule_table = {};
  std::string engine = {};
  std::size_t runs = 0;
  std::size_t runs_planned = 0;
  std::size_t shadow_runs = 0;
  double until_s = 0.0;

  static constexpr auto columns() {
    using io::column;
    return std::tuple{column("cell", &CellRow::cell, "", "its number"),
                      column("rule_table", &CellRow::rule_table, "", "of its runs"),
                      column("engine", &CellRow::engine, "", "of its runs"),
                      column("runs", &CellRow::runs, "", "that were measured"),
                      column("runs_planned", &CellRow::runs_planned, "", "that the plan has"),
                      column("shadow_runs", &CellRow::shadow_runs, "", "of its neutral shadow that were measured"),
                      column("until_s", &CellRow::until_s, "s", "how much of each run was measured")};
  }
};

/// runs.csv: one row a value of a run.
struct SweepRunRow {
  std::size_t run = 0;
  std::size_t cell = 0;
  std::size_t replicate = 0;
  bool shadow = false;
  std::uint64_t seed = 0;
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  double value = 0.0;

  static constexpr auto columns() {
    using io::column;
    return std::tuple{column("run", &SweepRunRow::run, "", "its index in the plan"),
                      column("cell", &SweepRunRow::cell, "", "the number of its cell"),
                      column("replicate", &SweepRunRow::replicate, "", "its number in the cell"),
                      column("shadow", &SweepRunRow::shadow, "", "1: a run of the cell's neutral shadow"),
                      column("seed", &SweepRunRow::seed, "", "of the run"),
                      column("metric", &SweepRunRow::metric, "", "what was measured; what could not be has no row"),
                      column("species", &SweepRunRow::species, "", "of whom; of a metric of two: prey+predator"),
                      column("group", &SweepRunRow::group, "", "as in metrics.csv"),
                      column("value", &SweepRunRow::value, "", "in the metric's unit, as in sweep_metrics.csv")};
  }
};

/// sweep_metrics.csv: one row a metric of a cell.
struct SweepMetricRow {
  std::size_t cell = 0;
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  std::string unit = {};
  std::size_t runs = 0;
  std::optional<double> mean = {};
  std::optional<double> deviation = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::size_t shadow_runs = 0;
  std::optional<double> shadow = {};
  std::size_t pairs = 0;
  std::optional<double> over_shadow = {};
  std::optional<double> over_lower = {};
  std::optional<double> over_upper = {};

  static constexpr auto columns() {
    using io::column;
    return std::tuple{
        column("cell", &SweepMetricRow::cell, "", "the number of the cell"),
        column("metric", &SweepMetricRow::metric, "", "what was measured"),
        column("species", &SweepMetricRow::species, "", "of whom; of a metric of two: prey+predator"),
        column("group", &SweepMetricRow::group, "", "as in metrics.csv"),
        column("unit", &SweepMetricRow::unit, "", "of all values of the row; 1 for shares and counts"),
        column("runs", &SweepMetricRow::runs, "", "in which it could be measured"),
        column("mean", &SweepMetricRow::mean, "", "over these runs"),
        column("deviation", &SweepMetricRow::deviation, "", "between these runs"),
        column("lower", &SweepMetricRow::lower, "", "of the mean's 95 % interval; empty for fewer than 6 runs"),
        column("upper", &SweepMetricRow::upper, "", "of the mean's 95 % interval"),
        column("shadow_runs", &SweepMetricRow::shadow_runs, "", "runs of the neutral shadow in which it could be measured"),
        column("shadow", &SweepMetricRow::shadow, "", "the mean over these runs"),
        column("pairs", &SweepMetricRow::pairs, "", "runs and shadows of one seed that both have a value"),
        column("over_shadow", &SweepMetricRow::over_shadow, "", "the mean over these pairs of run - shadow"),
        column("over_lower", &SweepMetricRow::over_lower, "",
               "of the 95 % interval of over_shadow; empty for fewer than 6 pairs"),
        column("over_upper", &SweepMetricRow::over_upper, "", "of the 95 % interval of over_shadow")};
  }
};

/// sweep_differences.csv: one row per metric of a cell, compared with the reference cell.
struct SweepDifferenceRow {
  std::size_t cell = 0;
  std::size_t reference = 0;
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  std::string unit = {};
  std::string compared = {};
  std::string design = {};
  std::size_t runs = 0;
  std::size_t runs_reference = 0;
  std::optional<double> mean = {};
  std::optional<double> mean_reference = {};
  std::optional<double> difference = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::optional<double> lower_corrected = {};
  std::optional<double> upper_corrected = {};
  std::optional<double> p = {};
  std::optional<double> p_holm = {};
  std::string significant = {};
  std::optional<double> hedges_g = {};
  std::optional<std::size_t> runs_needed = {};
  std::optional<double> smallest_detectable = {};

  static constexpr auto columns() {
    using io::column;
    return std::tuple{
        column("cell", &SweepDifferenceRow::cell, "", "the number of the cell"),
        column("reference", &SweepDifferenceRow::reference, "", "the number of the reference cell"),
        column("metric", &SweepDifferenceRow::metric, "", "what was measured"),
        column("species", &SweepDifferenceRow::species, "", "of whom; of a metric of two: prey+predator"),
        column("group", &SweepDifferenceRow::group, "", "as in metrics.csv"),
        column("unit", &SweepDifferenceRow::unit, "", "of means, differences and intervals"),
        column("compared", &SweepDifferenceRow::compared, "", "raw, or over_shadow: each run over its shadow first"),
        column("design", &SweepDifferenceRow::design, "",
               "paired: seed by seed, Student's t; independent: other seeds in each cell, Welch's t"),
        column("runs", &SweepDifferenceRow::runs, "", "of the cell that were compared; of a paired sweep the pairs"),
        column("runs_reference", &SweepDifferenceRow::runs_reference, "", "of the reference cell that were compared"),
        column("mean", &SweepDifferenceRow::mean, "", "over the cell's runs"),
        column("mean_reference", &SweepDifferenceRow::mean_reference, "", "over the reference cell's"),
        column("difference", &SweepDifferenceRow::difference, "", "mean - mean_reference"),
        column("lower", &SweepDifferenceRow::lower, "", "of this comparison's own 95 % interval; empty for fewer than 6 runs"),
        column("upper", &SweepDifferenceRow::upper, "", "of this comparison's own 95 % interval"),
        column("lower_corrected", &SweepDifferenceRow::lower_corrected, "",
               "of the interval that holds in all comparisons at once with 95 % (Bonferroni)"),
        column("upper_corrected", &SweepDifferenceRow::upper_corrected, "", "of the same interval"),
        column("p", &SweepDifferenceRow::p, "", "of this comparison alone"),
        column("p_holm", &SweepDifferenceRow::p_holm, "", "corrected for all comparisons of the analysis"),
        column("significant", &SweepDifferenceRow::significant, "", "yes where p_holm <= 0.05, else no; empty without a p value"),
        column("hedges_g", &SweepDifferenceRow::hedges_g, "",
               "the difference over the pooled standard deviation between runs of both cells, corrected for small numbers"),
        column("runs_needed", &SweepDifferenceRow::runs_needed, "",
               "runs in each cell that would show this difference with 80 % power at the corrected level, if it and the spread "
               "are what they seem"),
        column("smallest_detectable", &SweepDifferenceRow::smallest_detectable, "",
               "the difference that the runs at hand would show with 80 % power at the corrected level")};
  }
};

[[nodiscard]] SweepDifferenceRow row_of(const CellDifference& of, std::size_t reference);

}  // namespace trophic::analysis
