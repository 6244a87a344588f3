// SPDX-License-Identifier: MIT
// Many runs as one result: means, intervals, and what they say against each baseline.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/measure/bootstrap.hpp>
#include <trophic/measure/published.hpp>
#include <trophic/measure/run_metrics.hpp>
#include <utility>
#include <vector>

namespace trophic::measure {

/// Where an interval lies: all of it on one side of zero, or not.
enum class Verdict { unknown, below, not_distinguishable, above };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(Verdict) {
  return {"unknown", "below", "not distinguishable", "above"};
}
[[nodiscard]] constexpr Verdict verdict(const std::optional<Interval>& difference) {
  if (!difference) return Verdict::unknown;
  if (difference->lower > 0.0) return Verdict::above;
  return difference->upper < 0.0 ? Verdict::below : Verdict::not_distinguishable;
}

/// A mean over runs with its interval.
struct Estimate {
  std::size_t runs = 0;  ///< those in which it could be computed
  std::optional<double> mean;
  std::optional<Interval> interval;
};

[[nodiscard]] inline Estimate estimate(std::span<const double> values, const Bootstrap& how) {
  return {values.size(), mean_of(values), bootstrap_mean(values, how)};
}

/// Ours against one baseline, run by run.
struct Comparison {
  std::string baseline;
  bool of_paper = false;
  std::optional<double> value;  ///< the baseline's mean over the runs
  Estimate difference;          ///< ours - baseline, paired by run
  [[nodiscard]] Verdict verdict() const { return measure::verdict(difference.interval); }
};

struct SummaryRow {
  MetricName name;
  Estimate ours;
  std::optional<double> published;
  std::vector<Comparison> comparisons;

  /// The null models that say something else than the paper's own baseline does; nothing where there is no such pair.
  [[nodiscard]] std::vector<const Comparison*> contradictions() const {
    std::vector<const Comparison*> found;
    for (const Comparison& paper : comparisons) {
      if (!paper.of_paper || paper.verdict() == Verdict::unknown) continue;
      for (const Comparison& null : comparisons) {
        if (!null.of_paper && null.verdict() != Verdict::unknown && null.verdict() != paper.verdict()) found.push_back(&null);
      }
    }
    return found;
  }
};

/// Pools runs that measured the same things in the same order (those of one food web). Runs that lack a value are left out of
/// that value's mean. Throws std::invalid_argument if the runs measured different things.
[[nodiscard]] inline std::vector<SummaryRow> summarize(std::span<const RunMetrics> runs, const Bootstrap& how = {}) {
  std::vector<SummaryRow> rows;
  if (runs.empty()) return rows;
  const auto& first = runs.front().measurements;
  for (const RunMetrics& run : runs) {
    if (!std::ranges::equal(run.measurements, first, {}, &Measurement::name, &Measurement::name)) {
      throw std::invalid_argument{"runs with different food webs cannot be pooled"};
    }
  }
  for (std::size_t m = 0; m < first.size(); ++m) {
    std::vector<double> values;
    for (const RunMetrics& run : runs) {
      if (const auto& value = run.measurements[m].value) values.push_back(*value);
    }
    SummaryRow row{first[m].name, estimate(values, how), published(first[m].name), {}};
    for (std::size_t b = 0; b < first[m].baselines.size(); ++b) {
      std::vector<double> baseline;
      std::vector<double> differences;
      for (const RunMetrics& run : runs) {
        const Measurement& ours = run.measurements[m];
        if (!ours.baselines[b].value) continue;
        baseline.push_back(*ours.baselines[b].value);
        if (ours.value) differences.push_back(*ours.value - *ours.baselines[b].value);
      }
      const Baseline& named = first[m].baselines[b];
      row.comparisons.push_back({named.name, named.of_paper, mean_of(baseline), estimate(differences, how)});
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Set b against set a: mean(b) - mean(a) of one metric.
struct SetDifference {
  MetricName name;
  Estimate a;
  Estimate b;
  std::optional<double> difference;
  std::optional<Interval> interval;
};

/// For every metric that both sets measured, in the order of `a`.
[[nodiscard]] inline std::vector<SetDifference> compare_sets(std::span<const RunMetrics> a, std::span<const RunMetrics> b,
                                                             const Bootstrap& how = {}) {
  const auto values_of = [](std::span<const RunMetrics> runs, const MetricName& name) {
    std::vector<double> values;
    for (const RunMetrics& run : runs) {
      const auto found = std::ranges::find(run.measurements, name, &Measurement::name);
      if (found != run.measurements.end() && found->value) values.push_back(*found->value);
    }
    return values;
  };
  std::vector<SetDifference> differences;
  if (a.empty() || b.empty()) return differences;
  for (const Measurement& measurement : a.front().measurements) {
    const auto& in_b = b.front().measurements;
    if (std::ranges::find(in_b, measurement.name, &Measurement::name) == in_b.end()) continue;
    const auto of_a = values_of(a, measurement.name);
    const auto of_b = values_of(b, measurement.name);
    SetDifference d{measurement.name, estimate(of_a, how), estimate(of_b, how), {}, bootstrap_difference(of_a, of_b, how)};
    if (d.a.mean && d.b.mean) d.difference = *d.b.mean - *d.a.mean;
    differences.push_back(std::move(d));
  }
  return differences;
}

}  // namespace trophic::measure
