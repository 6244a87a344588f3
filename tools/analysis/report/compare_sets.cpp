// SPDX-License-Identifier: MIT
// Definitions of compare_sets.hpp.
#include <tools/analysis/report/compare_sets.hpp>

#include <algorithm>
#include <stdexcept>
#include <tools/analysis/metrics/metric_choice.hpp>
#include <tools/analysis/metrics/repeated_metrics.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <tools/analysis/statistics/power.hpp>
#include <utility>

namespace trophic::analysis {

void check_comparable(const RunManifest& a, const RunManifest& b) {
  if (lasted_alike(a, b)) return;
  throw std::invalid_argument{b.folder.string() + ": " + lasted_text(b) + ", but " + a.folder.string() + " has " +
                              lasted_text(a) + "; runs of different length are not compared: use --until"};
}

std::vector<SetDifference> compare_sets(const ShadowedSet& a, const ShadowedSet& b, std::span<const std::string> choices) {
  std::vector<MetricName> both;
  for (const Measurement& measurement : a.ours.runs.front().measurements) {
    const auto& of_b = b.ours.runs.front().measurements;
    if (std::ranges::find(of_b, measurement.name, &Measurement::name) != of_b.end()) both.push_back(measurement.name);
  }
  const std::vector<MetricName> names = chosen(both, choices);
  const std::array<std::span<const RunMetrics>, 4> sets{a.ours.runs, b.ours.runs, a.shadow_runs(), b.shadow_runs()};
  const auto repeats = repeated_metrics(sets, names);
  std::vector<SetDifference> all;
  for (std::size_t m = 0; m < names.size(); ++m) {
    const auto of_a = values_of(a.ours.runs, names[m]);
    const auto of_b = values_of(b.ours.runs, names[m]);
    SetDifference d{names[m], estimate(of_a), estimate(of_b), {}, {}, repeats[m]};
    std::optional<double> raw;
    if (d.a.mean && d.b.mean) raw = *d.b.mean - *d.a.mean;
    d.raw = difference_of(raw, contrast({{-1.0, of_a}, {1.0, of_b}}), scatter_of(of_a, of_b));
    if (a.shadow && b.shadow) {
      const auto null_a = values_of(a.shadow_runs(), names[m]);
      const auto null_b = values_of(b.shadow_runs(), names[m]);
      std::optional<double> over;
      if (raw && !null_a.empty() && !null_b.empty()) over = *raw + *mean_of(null_a) - *mean_of(null_b);
      d.over_shadow = difference_of(over, contrast({{-1.0, of_a}, {1.0, null_a}, {1.0, of_b}, {-1.0, null_b}}),
                                    scatter_of({of_a, null_a, of_b, null_b}));
    }
    all.push_back(std::move(d));
  }
  for (Difference SetDifference::*kind : {&SetDifference::raw, &SetDifference::over_shadow}) {
    std::vector<Difference*> together;
    for (SetDifference& each : all) {
      if (!each.same_as) together.push_back(&(each.*kind));
    }
    adjust_together(together);
  }
  return all;
}

}  // namespace trophic::analysis
