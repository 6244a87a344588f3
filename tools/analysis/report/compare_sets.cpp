// SPDX-License-Identifier: MIT
// Definitions of compare_sets.hpp.
#include <tools/analysis/report/compare_sets.hpp>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <tools/analysis/statistics/interval.hpp>
#include <utility>

namespace trophic::analysis {

void check_comparable(const RunManifest& a, const RunManifest& b) {
  if (lasted_alike(a, b)) return;
  throw std::invalid_argument{b.folder.string() + ": " + lasted_text(b) + ", but " + a.folder.string() + " has " +
                              lasted_text(a) + "; runs of different length are not compared: use --until"};
}

std::vector<SetDifference> compare_sets(const ShadowedSet& a, const ShadowedSet& b) {
  std::vector<SetDifference> all;
  for (const Measurement& measurement : a.ours.runs.front().measurements) {
    const MetricName& name = measurement.name;
    if (std::ranges::find(b.ours.runs.front().measurements, name, &Measurement::name) == b.ours.runs.front().measurements.end()) {
      continue;
    }
    const auto of_a = values_of(a.ours.runs, name);
    const auto of_b = values_of(b.ours.runs, name);
    SetDifference d{name, estimate(of_a), estimate(of_b), {}, {}};
    std::optional<double> raw;
    if (d.a.mean && d.b.mean) raw = *d.b.mean - *d.a.mean;
    d.raw = difference_of(raw, contrast({{-1.0, of_a}, {1.0, of_b}}));
    if (a.shadow && b.shadow) {
      const auto null_a = values_of(a.shadow_runs(), name);
      const auto null_b = values_of(b.shadow_runs(), name);
      std::optional<double> over;
      if (raw && !null_a.empty() && !null_b.empty()) over = *raw + *mean_of(null_a) - *mean_of(null_b);
      d.over_shadow = difference_of(over, contrast({{-1.0, of_a}, {1.0, null_a}, {1.0, of_b}, {-1.0, null_b}}));
    }
    all.push_back(std::move(d));
  }
  for (Difference SetDifference::*kind : {&SetDifference::raw, &SetDifference::over_shadow}) {
    std::vector<Difference*> together;
    for (SetDifference& each : all) together.push_back(&(each.*kind));
    adjust_together(together);
  }
  return all;
}

}  // namespace trophic::analysis
