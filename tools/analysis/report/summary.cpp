// SPDX-License-Identifier: MIT
// Definitions of summary.hpp.
#include <tools/analysis/report/summary.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace trophic::analysis::detail {

Comparison against_shadow(std::span<const double> ours, std::span<const double> shadow) {
  Comparison comparison{std::string{shadow_name}, Role::null, mean_of(shadow), {}, interval_of_difference(shadow, ours)};
  if (!ours.empty() && !shadow.empty()) comparison.difference = *mean_of(ours) - *mean_of(shadow);
  return comparison;
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
  Comparison comparison{named.name, named.role, mean_of(values), {}, {}};
  if (named.role != Role::null) return comparison;
  comparison.difference = mean_of(differences);
  comparison.interval = interval_of_mean(differences);
  return comparison;
}

}  // namespace trophic::analysis::detail

namespace trophic::analysis {

std::vector<SummaryRow> summarize(std::span<const RunMetrics> runs, std::span<const RunMetrics> shadow) {
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
  for (std::size_t m = 0; m < first.size(); ++m) {
    const std::vector<double> values = values_of(runs, first[m].name);
    SummaryRow row{first[m].name, estimate(values), published(first[m].name), {}};
    if (!shadow.empty()) row.comparisons.push_back(detail::against_shadow(values, values_of(shadow, first[m].name)));
    for (std::size_t b = 0; b < first[m].baselines.size(); ++b) row.comparisons.push_back(detail::against_own(runs, m, b));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace trophic::analysis
