// SPDX-License-Identifier: MIT
// Results for papers: means.csv and means.tex of sets, differences.csv and differences.tex of a comparison.
#pragma once

#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <tools/analysis/report/summary.hpp>
#include <trophic/io/column.hpp>

namespace trophic::analysis {

/// means.csv: each metric of each set next to each of its nulls, one row each; one row for a metric without a null.
struct MeanRow {
  std::string set = {};
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  std::string unit = {};
  std::size_t n = 0;
  std::optional<double> mean = {};
  std::optional<double> deviation = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::optional<double> published = {};
  std::string null = {};
  std::size_t null_n = 0;
  std::optional<double> null_mean = {};
  std::optional<double> difference = {};
  std::optional<double> difference_lower = {};
  std::optional<double> difference_upper = {};
  std::optional<double> p = {};
  std::optional<double> p_holm = {};
  std::optional<std::size_t> runs_needed = {};
  std::string same_as = {};

  static constexpr auto columns() {
    using io::column;
    return std::tuple{
        column("set", &MeanRow::set, "", "name of the rule table"),
        column("metric", &MeanRow::metric, "", "what was measured"),
        column("species", &MeanRow::species, "", "of whom; of a metric of two: prey+predator"),
        column("group", &MeanRow::group, "", "as in metrics.csv"),
        column("unit", &MeanRow::unit, "", "of means, differences and intervals"),
        column("n", &MeanRow::n, "", "runs in which it could be measured"),
        column("mean", &MeanRow::mean, "", "over these runs"),
        column("deviation", &MeanRow::deviation, "", "between these runs"),
        column("lower", &MeanRow::lower, "", "of the mean's 95 % interval; empty for fewer than 6 runs"),
        column("upper", &MeanRow::upper, "", "of the mean's 95 % interval"),
        column("published", &MeanRow::published, "", "the paper's mean; empty if it has none"),
        column("null", &MeanRow::null, "", "shadow, or the name of a null that each run has of its own; empty: no null"),
        column("null_n", &MeanRow::null_n, "", "runs that give the null"),
        column("null_mean", &MeanRow::null_mean, "", "over these runs"),
        column("difference", &MeanRow::difference, "", "mean - null_mean; of a run's own null over the runs that have both"),
        column("difference_lower", &MeanRow::difference_lower, "", "of its own 95 % interval"),
        column("difference_upper", &MeanRow::difference_upper, "", "of its own 95 % interval"),
        column("p", &MeanRow::p, "", "of this comparison alone"),
        column("p_holm", &MeanRow::p_holm, "", "corrected for all comparisons of the set"),
        column("runs_needed", &MeanRow::runs_needed, "",
               "if p_holm > 0.05: runs in each set that would find a difference of this size in 80 % of studies"),
        column("same_as", &MeanRow::same_as, "",
               "an earlier metric that says the same (other reading, or the same in every run); then not compared again")};
  }
};

/// differences.csv: each metric of two sets, raw and over their shadows.
struct SetDifferenceRow {
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  std::string unit = {};
  std::string compared = {};
  std::size_t n_a = 0;
  std::size_t n_b = 0;
  std::optional<double> mean_a = {};
  std::optional<double> mean_b = {};
  std::optional<double> difference = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::optional<double> p = {};
  std::optional<double> p_holm = {};
  std::optional<std::size_t> runs_needed = {};
  std::string same_as = {};

  static constexpr auto columns() {
    using io::column;
    using Row = SetDifferenceRow;
    return std::tuple{
        column("metric", &Row::metric, "", "what was measured"),
        column("species", &Row::species, "", "of whom; of a metric of two: prey+predator"),
        column("group", &Row::group, "", "as in metrics.csv"),
        column("unit", &Row::unit, "", "of means, differences and intervals"),
        column("compared", &Row::compared, "", "over_shadow: (b - its shadow) - (a - its shadow), the answer; raw: b - a"),
        column("n_a", &Row::n_a, "", "runs of the first set"),
        column("n_b", &Row::n_b, "", "runs of the second set"),
        column("mean_a", &Row::mean_a, "", "of the first set, raw"),
        column("mean_b", &Row::mean_b, "", "of the second set, raw"),
        column("difference", &Row::difference, "", "as `compared` says"),
        column("lower", &Row::lower, "", "of this comparison's own 95 % interval; empty for fewer than 6 runs"),
        column("upper", &Row::upper, "", "of this comparison's own 95 % interval"),
        column("p", &Row::p, "", "of this comparison alone"),
        column("p_holm", &Row::p_holm, "", "corrected for all metrics"),
        column("runs_needed", &Row::runs_needed, "",
               "if p_holm > 0.05: runs in each set that would find a difference of this size in 80 % of studies"),
        column("same_as", &Row::same_as, "",
               "an earlier metric that says the same (other reading, or the same in every run); then not compared again")};
  }
};

/// A set with what summarize made of it.
struct SummarizedSet {
  const ShadowedSet* set = nullptr;
  std::vector<SummaryRow> rows;
};

/// Throws std::runtime_error if the file exists or cannot be written.
void write_means(const std::filesystem::path& path, std::span<const SummarizedSet> sets);
void write_differences(const std::filesystem::path& path, std::span<const SetDifference> differences);

/// A LaTeX table (booktabs, tabularx) as wide as the line that it is put into: what was compared with a null, each once.
[[nodiscard]] std::string means_tex(const SummarizedSet& set);
/// The same of a comparison: over the shadows if both sets have one, else raw.
[[nodiscard]] std::string differences_tex(const ShadowedSet& a, const ShadowedSet& b, std::span<const SetDifference> differences);

}  // namespace trophic::analysis
