// SPDX-License-Identifier: MIT
// Definitions of summary.hpp.
#include <tools/analysis/report/summary.hpp>

#include <algorithm>
#include <stdexcept>
#include <tools/analysis/metrics/metric_choice.hpp>
#include <tools/analysis/metrics/repeated_metrics.hpp>
#include <utility>

namespace trophic::analysis::detail {

Comparison against_shadow(std::span<const double> ours, std::span<const double> shadow) {
  std::optional<double> value;
  if (!ours.empty() && !shadow.empty()) value = *mean_of(ours) - *mean_of(shadow);
  return {std::string{shadow_name}, Role::null, mean_of(shadow), shadow.size(),
          difference_of(value, contrast({{-1.0, shadow}, {1.0, ours}}), scatter_of(shadow, ours))};
}

Comparison against_own(std::span<const RunMetrics> runs, std::size_t measurement, std::size_t baseline) {
  std::vector<double> values;
  std::vector<double> differences;
  for (const RunMetrics& run : runs) {
    const Measurement& ours = run.measurements[measurement];
    const auto& value = ours.baselines[baseline].value;
    if (value) values.push_back(*value);
    if (value && ours.value) differences.push_back(*ours.value - *value);
  }
  const Baseline& named = runs.front().measurements[measurement].baselines[baseline];
  Comparison comparison{named.name, named.role, mean_of(values), values.size()};
  if (named.role != Role::null) return comparison;
  comparison.difference = difference_of(mean_of(differences), contrast({{1.0, differences}}), scatter_of(differences));
  return comparison;
}

}  // namespace trophic::analysis::detail

namespace trophic::analysis {

std::vector<SummaryRow> summarize(std::span<const RunMetrics> runs, std::span<const RunMetrics> shadow,
                                  std::span<const std::string> choices) {
  std::vector<SummaryRow> rows;
  if (runs.empty()) return rows;
  const auto& first = runs.front().measurements;
  for (const std::span<const RunMetrics> set : {runs, shadow}) {
    for (const RunMetrics& run : set) {
      if (!std::ranges::equal(run.measurements, first, {}, &Measurement::name, &Measurement::name)) {
        throw std::invalid_argument{"runs with different food webs cannot be pooled"};
      }
    }
  }
  const std::array sets{runs, shadow};
  std::vector<MetricName> names;
  for (const Measurement& measurement : first) names.push_back(measurement.name);
  const std::vector<MetricName> wanted = chosen(names, choices);
  const auto repeats = repeated_metrics(sets, wanted);
  for (std::size_t m = 0; m < first.size(); ++m) {
    const auto place = std::ranges::find(wanted, first[m].name);
    if (place == wanted.end()) continue;
    const std::vector<double> values = values_of(runs, first[m].name);
    SummaryRow row{first[m].name, estimate(values), published(first[m].name), {}};
    row.same_as = repeats[static_cast<std::size_t>(place - wanted.begin())];
    if (!shadow.empty()) row.comparisons.push_back(detail::against_shadow(values, values_of(shadow, first[m].name)));
    for (std::size_t b = 0; b < first[m].baselines.size(); ++b) row.comparisons.push_back(detail::against_own(runs, m, b));
    rows.push_back(std::move(row));
  }
  std::vector<Difference*> together;
  for (SummaryRow& row : rows) {
    for (Comparison& comparison : row.comparisons) {
      if (comparison.role == Role::null && !row.same_as) together.push_back(&comparison.difference);
    }
  }
  adjust_together(together);
  return rows;
}

}  // namespace trophic::analysis
