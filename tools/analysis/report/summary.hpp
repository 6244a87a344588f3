// SPDX-License-Identifier: MIT
// Many runs as one result: means, intervals, and what they say against each null.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/report/published.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <utility>
#include <vector>

namespace trophic::analysis {

/// Ours beside another value. Only a null has a difference, and a verdict.
struct Comparison {
  std::string baseline;
  Role role = Role::reference;
  std::optional<double> value;       ///< the baseline's mean over the runs
  std::optional<double> difference;  ///< ours - null
  std::optional<Interval> interval;  ///< of the difference
  [[nodiscard]] Verdict verdict() const { return analysis::verdict(interval); }
};

struct SummaryRow {
  MetricName name;
  Estimate ours;
  std::optional<double> published;
  std::vector<Comparison> comparisons;  ///< the shadow first, where there is one
};

/// The name of the comparison with the neutral shadow.
inline constexpr std::string_view shadow_name = "shadow";

namespace detail {

/// As two independent sets. Runs and shadows of one seed are slightly alike (kinematic, 60 seeds, 41 metrics: correlation 0.13 in
/// the median, 0.47 at most), so that intervals are rather too wide. Pairing would gain that, and at ten runs lose as much in
/// degrees of freedom.
[[nodiscard]] inline Comparison against_shadow(std::span<const double> ours, std::span<const double> shadow) {
  Comparison comparison{std::string{shadow_name}, Role::null, mean_of(shadow), {}, interval_of_difference(shadow, ours)};
  if (!ours.empty() && !shadow.empty()) comparison.difference = *mean_of(ours) - *mean_of(shadow);
  return comparison;
}

/// A baseline that each run has of its own: paired by run.
[[nodiscard]] inline Comparison against_own(std::span<const RunMetrics> runs, std::size_t measurement, std::size_t baseline) {
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

}  // namespace detail

/// Pools runs that measured the same things in the same order (those of one food web), and sets them beside the runs of their
/// shadow. Runs that lack a value are left out of that value's mean. Throws std::invalid_argument if the runs measured different
/// things.
[[nodiscard]] inline std::vector<SummaryRow> summarize(std::span<const RunMetrics> runs,
                                                       std::span<const RunMetrics> shadow = {}) {
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
