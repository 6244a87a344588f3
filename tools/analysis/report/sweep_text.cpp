// SPDX-License-Identifier: MIT
// Definitions of sweep_text.hpp.
#include <tools/analysis/report/sweep_text.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <tools/analysis/report/columns.hpp>
#include <tools/analysis/report/reading.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis::detail {

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string decimals(double value, int count, bool sign) {
  std::string text(64, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), sign ? "%+.*f" : "%.*f", count, value)));
  return text;
}

std::string axis_title(std::span<const Axis> axes, const Axis& axis) {
  const auto tail = [](const std::string& name) { return name.substr(name.rfind('.') + 1); };
  const auto alike = std::ranges::count_if(axes, [&](const Axis& other) { return tail(other.name) == tail(axis.name); });
  return alike > 1 ? axis.name : tail(axis.name);
}

std::string cell_title(const SweepGrid& grid, std::size_t number) {
  const auto place = static_cast<std::size_t>(grid.find(number) - grid.cells.data());
  std::string text;
  for (const Axis& axis : grid.axes) {
    const std::string value = axis.values[place].empty() ? "unset" : axis.values[place];
    text += (text.empty() ? "" : ", ") + axis_title(grid.axes, axis) + " " + value;
  }
  return text;
}

std::string values_on(const Axis& axis) {
  constexpr std::size_t shown = 8;
  std::vector<std::string> values;
  for (const std::string& value : axis.values) {
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, values.size()); ++i) {
    text += (i > 0 ? ", " : "") + (values[i].empty() ? std::string{"unset"} : values[i]);
  }
  return text + (values.size() > shown ? ", ... (" + std::to_string(values.size()) + " values)" : "");
}

std::string compared_title(const CellDifference& d) {
  return metric_title(d.name) + (d.over_shadow ? ", over shadow" : "");
}

std::vector<SignificantMetric> significant_metrics(const CellDifferences& differences) {
  std::vector<SignificantMetric> metrics;
  for (const CellDifference& d : differences.all) {
    if (!d.difference.differs()) continue;
    auto found = std::ranges::find_if(metrics, [&](const SignificantMetric& other) { return other.largest->name == d.name; });
    if (found == metrics.end()) found = metrics.insert(found, {&d, 0});
    ++found->cells;
    if (std::abs(*d.difference.value) > std::abs(*found->largest->difference.value)) found->largest = &d;
  }
  std::ranges::stable_sort(metrics, std::ranges::greater{}, &SignificantMetric::cells);
  return metrics;
}

void print_significant_metrics(std::ostream& out, const SweepGrid& grid, const CellDifferences& differences) {
  const std::vector<SignificantMetric> metrics = significant_metrics(differences);
  if (metrics.empty()) {
    out << "no comparison is significant\n";
    return;
  }
  constexpr std::size_t shown = 20;
  Columns columns{{"significant metric", "cells", "largest difference [corrected]", "g", "in cell"}};
  for (const SignificantMetric& metric : std::span{metrics}.first(std::min(shown, metrics.size()))) {
    const CellDifference& d = *metric.largest;
    columns.add({compared_title(d), std::to_string(metric.cells) + "/" + std::to_string(grid.cells.size() - 1),
                 Reading{d.name}.with_interval(d.difference.value, d.corrected, true),
                 d.hedges_g ? decimals(*d.hedges_g, 1, true) : "-",
                 std::to_string(d.cell) + " (" + cell_title(grid, d.cell) + ")"});
  }
  columns.print(out);
  if (metrics.size() > shown)
    out << "and " << counted(metrics.size() - shown, "metric") << " more: significant in sweep_differences.csv\n";
  out << "significant: p <= 0.05, corrected (Holm), which finds a little more than intervals that hold all at once; g: Hedges'\n";
}

}  // namespace trophic::analysis::detail

namespace trophic::analysis {

void print_sweep(std::ostream& out, const SweepRuns& sweep, const CellDifferences& differences, std::size_t reference,
                 std::optional<double> until_s) {
  const auto there = static_cast<std::size_t>(std::ranges::count(sweep.is_there, true));
  const double lasted_s = until_s.value_or(sweep.plan.front().until_s);
  out << "sweep of " << detail::counted(sweep.grid.cells.size(), "cell") << ", " << detail::counted(there, "run") << " of "
      << number_text(lasted_s) << " s\n";
  for (const Axis& axis : sweep.grid.axes) out << "axis " << axis.name << ": " << detail::values_on(axis) << "\n";
  out << "reference: cell " << reference;
  if (!sweep.grid.axes.empty()) out << " (" << detail::cell_title(sweep.grid, reference) << ")";
  out << "\n";
  if (differences.all.empty()) {
    out << "one cell alone: there is nothing to compare\n";
    return;
  }
  std::set<bool> designs;
  for (const CellDifference& d : differences.all) designs.insert(d.paired);
  const std::string_view design = designs.size() > 1 ? "seed by seed where cells share seeds, else as independent sets"
                                  : *designs.begin() ? "seed by seed"
                                                     : "as independent sets (other seeds in each cell)";
  out << detail::counted(differences.comparisons, "comparison") << " with it, " << design
      << "; p corrected for all of them (Holm), "
      << "intervals, too (Bonferroni)\n";
}

void print_cell_differences(std::ostream& out, const SweepGrid& grid, const CellDifferences& differences) {
  if (differences.all.empty()) return;
  detail::print_significant_metrics(out, grid, differences);
  std::size_t significant = 0;
  std::size_t too_few = 0;
  std::vector<std::string> open;
  std::set<std::string> tested;
  for (const CellDifference& d : differences.all) {
    if (detail::is_comparison(d) && !d.difference.p) ++too_few;
    if (!d.difference.differs()) continue;
    ++significant;
    tested.insert(metric_title(d.name));
  }
  for (const CellDifference& d : differences.all) {
    const std::string title = metric_title(d.name);
    if (!detail::is_comparison(d) || tested.contains(title)) continue;
    if (std::ranges::find(open, title) == open.end()) open.push_back(title);
  }
  const std::size_t inconclusive = differences.comparisons - significant;
  if (inconclusive > 0) {
    out << "inconclusive: " << inconclusive << " of " << differences.comparisons << " comparisons; this does not show equality\n";
  }
  if (!open.empty()) {
    constexpr std::size_t shown = 6;
    out << "inconclusive in every cell: " << detail::counted(open.size(), "metric") << ": ";
    for (std::size_t i = 0; i < std::min(shown, open.size()); ++i) out << (i > 0 ? "; " : "") << open[i];
    out << (open.size() > shown ? "; ...\n" : "\n");
  }
  if (too_few > 0) {
    out << "too few runs for a test in " << too_few << " of them: " << min_runs_for_test << " in each cell are needed\n";
  }
  if (inconclusive > 0) {
    out << "runs_needed and smallest_detectable in sweep_differences.csv say what more runs would show; fewer metrics "
           "(--metric), "
           "chosen before looking, need fewer runs\n";
  }
}

void print_named_metrics(std::ostream& out, const SweepGrid& grid, const CellDifferences& differences) {
  if (differences.all.empty()) return;
  Columns columns{{"metric", "cell", "mean", "reference", "difference [95 %]", "p", "g", "runs", "runs needed"}};
  std::vector<std::string> constant;
  for (const CellDifference& d : differences.all) {
    const auto is_same = [&](const CellDifference& other) { return other.name == d.name && detail::is_comparison(other); };
    if (std::ranges::none_of(differences.all, is_same)) {
      if (std::ranges::find(constant, metric_title(d.name)) == constant.end()) constant.push_back(metric_title(d.name));
      continue;
    }
    const Reading reading{d.name};
    const bool is_open = detail::is_comparison(d) && !d.difference.differs();
    columns.add({detail::compared_title(d), std::to_string(d.cell) + " (" + detail::cell_title(grid, d.cell) + ")",
                 reading(d.mean), reading(d.mean_reference),
                 reading.with_interval(d.difference.value, d.difference.interval, true), p_text(d.difference.adjusted),
                 d.hedges_g ? detail::decimals(*d.hedges_g, 1, true) : "-",
                 std::to_string(d.runs) + "+" + std::to_string(d.runs_reference),
                 !is_open        ? ""
                 : d.runs_needed ? std::to_string(*d.runs_needed)
                                 : "more than " + std::to_string(most_runs)});
  }
  columns.print(out);
  for (const std::string& title : constant) out << "the same in all runs, or without a value: " << title << "\n";
  out << "p: corrected for all comparisons (Holm); runs needed: in each cell, to find a difference of this size in 80 % of "
         "studies\n";
}

void print_runs_for_difference(std::ostream& out, std::span<const RunsForDifference> answers, const CellDifferences& of) {
  for (const RunsForDifference& answer : answers) {
    const Reading reading{answer.name};
    out << "a difference of " << reading(answer.difference) << " in " << metric_title(answer.name)
        << (answer.over_shadow ? ", over shadow" : "") << " needs ";
    const auto runs = [](const std::optional<std::size_t>& count) {
      return count ? std::to_string(*count) : "more than " + std::to_string(most_runs);
    };
    if (answer.cells == 0) {
      out << "an unknown number of replicates: fewer than two were compared\n";
      continue;
    }
    out << runs(answer.runs) << " replicates a cell (" << runs(answer.fewest) << " to " << runs(answer.most)
        << ", cell by cell) for 80 % power\n";
  }
  if (!answers.empty()) {
    out << "at the level of one of " << detail::counted(of.comparisons, "comparison") << ", " << number_text(of.level())
        << "; by the spread of the runs at hand\n";
  }
}

}  // namespace trophic::analysis
