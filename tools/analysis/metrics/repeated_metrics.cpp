// SPDX-License-Identifier: MIT
// Definitions of repeated_metrics.hpp.
#include <tools/analysis/metrics/repeated_metrics.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace trophic::analysis {

namespace {

/// Two metrics of fewer values may agree by chance.
constexpr std::size_t fewest_values = 6;

using Values = std::vector<std::optional<double>>;  ///< one a run

Values values_in(std::span<const std::span<const RunMetrics>> sets, const MetricName& name) {
  Values values;
  for (const std::span<const RunMetrics> set : sets) {
    for (const RunMetrics& run : set) {
      const auto found = std::ranges::find(run.measurements, name, &Measurement::name);
      values.push_back(found == run.measurements.end() ? std::nullopt : found->value);
    }
  }
  return values;
}

/// Whether b + sign * a is the same number, but for rounding, wherever there is one.
bool is_constant(const Values& a, const Values& b, double sign) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].has_value() != b[i].has_value()) return false;
    if (!a[i]) continue;
    lowest = std::min(lowest, *b[i] + sign * *a[i]);
    highest = std::max(highest, *b[i] + sign * *a[i]);
    largest = std::max({largest, std::abs(*a[i]), std::abs(*b[i])});
  }
  return highest - lowest <= 1e-12 * largest;
}

bool can_repeat(const Values& values) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  std::size_t count = 0;
  for (const std::optional<double>& value : values) {
    if (!value) continue;
    ++count;
    lowest = std::min(lowest, *value);
    highest = std::max(highest, *value);
  }
  return count >= fewest_values && lowest < highest;
}

/// The metric of which this one is another reading of the paper's text.
std::optional<MetricName> plain_reading(MetricName name) {
  if (name.metric != "velocity_points" && name.metric != "velocity_stored") return std::nullopt;
  name.metric = "velocity";
  return name;
}

}  // namespace

std::vector<std::optional<MetricName>> repeated_metrics(std::span<const std::span<const RunMetrics>> sets,
                                                        std::span<const MetricName> names) {
  std::vector<Values> all;
  for (const MetricName& name : names) all.push_back(values_in(sets, name));
  return repeated_values(all, names);
}

std::vector<std::optional<MetricName>> repeated_values(std::span<const Values> all, std::span<const MetricName> names) {
  std::vector<std::optional<MetricName>> repeats(names.size());
  for (std::size_t later = 0; later < names.size(); ++later) {
    const auto plain = plain_reading(names[later]);
    if (plain && std::ranges::find(names, *plain) != names.end()) repeats[later] = plain;
    if (!can_repeat(all[later])) continue;
    for (std::size_t earlier = 0; earlier < later && !repeats[later]; ++earlier) {
      if (repeats[earlier] || names[earlier].unit != names[later].unit) continue;
      if (is_constant(all[earlier], all[later], -1.0) || is_constant(all[earlier], all[later], 1.0))
        repeats[later] = names[earlier];
    }
  }
  return repeats;
}

}  // namespace trophic::analysis
