// SPDX-License-Identifier: MIT
// Definitions of cell_differences.hpp.
#include <tools/analysis/report/cell_differences.hpp>

#include <cmath>
#include <stdexcept>
#include <tools/analysis/metrics/repeated_metrics.hpp>
#include <tools/analysis/report/swaps.hpp>
#include <tools/analysis/statistics/holm.hpp>

namespace trophic::analysis::detail {

ComparedValues compared_values(const std::map<std::uint64_t, double>& reference, const std::map<std::uint64_t, double>& cell,
                               bool paired) {
  ComparedValues values;
  for (const auto& [seed, value] : reference) {
    if (!paired || cell.contains(seed)) values.reference.push_back(value);
  }
  for (const auto& [seed, value] : cell) {
    if (!paired || reference.contains(seed)) values.cell.push_back(value);
  }
  return values;
}

std::pair<std::optional<Contrast>, std::optional<Scatter>> compared(const ComparedValues& values, bool paired) {
  if (!paired) {
    return {contrast({{-1.0, values.reference}, {1.0, values.cell}}), scatter_of(values.reference, values.cell)};
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < values.cell.size(); ++i) differences.push_back(values.cell[i] - values.reference[i]);
  return {contrast({{1.0, differences}}), scatter_of(differences)};
}

std::pair<CellDifference, std::optional<Contrast>> compare_values(const ComparedValues& values, bool paired) {
  CellDifference d;
  d.paired = paired;
  d.runs = values.cell.size();
  d.runs_reference = values.reference.size();
  d.mean = mean_of(values.cell);
  d.mean_reference = mean_of(values.reference);
  const auto [of, scatter] = compared(values, paired);
  std::optional<double> value;
  if (d.mean && d.mean_reference) value = *d.mean - *d.mean_reference;
  d.difference = difference_of(value, of);
  d.hedges_g = hedges_g(values.reference, values.cell);
  d.scatter = scatter;
  return {d, of};
}

bool is_comparison(const CellDifference& d) {
  if (!d.scatter || !d.difference.value) return false;
  return !is_rounding(std::sqrt(d.scatter->variance), *d.mean) || !is_rounding(std::abs(*d.difference.value), *d.mean);
}

void adjust(std::span<CellDifference> all) {
  std::vector<double> p_values;
  for (const CellDifference& d : all) {
    if (is_comparison(d)) p_values.push_back(d.difference.p.value_or(1.0));
  }
  const std::vector<double> adjusted = holm(p_values);
  std::size_t k = 0;
  for (CellDifference& d : all) {
    if (!is_comparison(d)) continue;
    if (d.difference.p) d.difference.adjusted = adjusted[k];
    ++k;
  }
}

}  // namespace trophic::analysis::detail

namespace trophic::analysis {

std::vector<MetricName> distinct_metrics(const SweepValues& values) {
  std::vector<std::vector<std::optional<double>>> by_name(values.names.size());
  for (std::size_t name = 0; name < by_name.size(); ++name) {
    for (std::size_t run = 0; run < values.of_run.size(); ++run) by_name[name].push_back(values.value(run, name));
  }
  const auto repeats = repeated_values(by_name, values.names);
  std::vector<MetricName> distinct;
  for (std::size_t name = 0; name < by_name.size(); ++name) {
    const auto& earlier = repeats[name];
    if (!earlier || needs_shadow(*earlier) != needs_shadow(values.names[name])) distinct.push_back(values.names[name]);
  }
  return distinct;
}

CellDifferences compare_cells(const SweepGrid& grid, const SweepValues& values, std::size_t reference,
                              std::span<const MetricName> names) {
  const GridCell* base = grid.find(reference);
  if (base == nullptr) {
    throw std::invalid_argument{"reference = " + std::to_string(reference) + ": must be a cell of the sweep, " +
                                std::to_string(grid.cells.front().number) + " to " + std::to_string(grid.cells.back().number)};
  }
  CellDifferences differences;
  std::vector<std::optional<Contrast>> contrasts;
  std::vector<CellValues> of_base;
  for (const MetricName& name : names) of_base.push_back(cell_values(*base, values, values.place_of(name)));
  for (const GridCell& cell : grid.cells) {
    if (cell.number == reference) continue;
    const bool paired = is_paired(*base, cell);
    for (std::size_t m = 0; m < names.size(); ++m) {
      const CellValues of_cell = cell_values(cell, values, values.place_of(names[m]));
      const bool over = needs_shadow(names[m]) && !of_cell.over_shadow.empty() && !of_base[m].over_shadow.empty();
      const auto kind = over ? &CellValues::over_shadow : &CellValues::raw;
      auto [d, of] = detail::compare_values(detail::compared_values(of_base[m].*kind, of_cell.*kind, paired), paired);
      d.cell = cell.number;
      d.name = names[m];
      d.over_shadow = over;
      if (detail::is_comparison(d)) {
        ++differences.comparisons;
      } else {
        d.difference.p.reset();
      }
      differences.all.push_back(std::move(d));
      contrasts.push_back(of);
    }
  }
  detail::adjust(differences.all);
  const double level = differences.level();
  for (std::size_t i = 0; i < differences.all.size(); ++i) {
    CellDifference& d = differences.all[i];
    if (!detail::is_comparison(d)) continue;
    d.corrected = interval_of(contrasts[i], 1.0 - level);
    d.runs_needed = runs_for_power(*d.difference.value, *d.scatter, level);
    if (contrasts[i]) d.detectable = detectable_difference(*contrasts[i], level);
  }
  return differences;
}

std::vector<RunsForDifference> runs_for_difference(const CellDifferences& differences, double difference) {
  std::map<MetricName, std::vector<const CellDifference*>> by_metric;
  std::vector<MetricName> order;
  for (const CellDifference& d : differences.all) {
    auto& list = by_metric[d.name];
    if (list.empty()) order.push_back(d.name);
    list.push_back(&d);
  }
  std::vector<RunsForDifference> answers;
  for (const MetricName& name : order) {
    RunsForDifference answer;
    answer.name = name;
    answer.difference = difference;
    Scatter mean{0.0, 0.0};
    std::vector<Scatter> scatters;
    for (const CellDifference* d : by_metric[name]) {
      if (!d->scatter) continue;
      answer.over_shadow = answer.over_shadow || d->over_shadow;
      scatters.push_back(*d->scatter);
      mean.variance += d->scatter->variance;
      mean.freedom += d->scatter->freedom;
    }
    answer.cells = scatters.size();
    if (!scatters.empty()) {
      const auto count = static_cast<double>(scatters.size());
      const auto runs = [&](const Scatter& of) { return runs_for_power(difference, of, differences.level()); };
      const auto [least, most] = std::ranges::minmax(scatters, {}, &Scatter::variance);
      answer.runs = runs({mean.variance / count, mean.freedom / count});
      answer.fewest = runs(least);
      answer.most = runs(most);
    }
    answers.push_back(answer);
  }
  return answers;
}

}  // namespace trophic::analysis
