// SPDX-License-Identifier: MIT
// Definitions of sampled_metric.hpp.
#include <tools/analysis/metrics/sampled_metric.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace trophic::analysis {

namespace {

constexpr double curve_window_s = 200.0;
constexpr std::size_t most_parts = 1000;

}  // namespace

SampledMetric::SampledMetric(std::string metric, std::string unit, bool is_one)
    : metric_{std::move(metric)}, unit_{std::move(unit)} {
  if (is_one) parts_.push_back({{metric_, "", "all", unit_}, WindowMean{curve_window_s}});
}

void SampledMetric::add(const std::string& species, const std::string& group, std::optional<double> time_s,
                        std::optional<double> value) {
  const auto is_its = [&](const Part& part) { return part.name.species == species && part.name.group == group; };
  auto part = std::ranges::find_if(parts_, is_its);
  if (part == parts_.end() && parts_.size() == most_parts) {
    throw std::invalid_argument{metric_ + ": must be of at most " + std::to_string(most_parts) + " species and groups"};
  }
  if (part == parts_.end()) part = parts_.insert(parts_.end(), {{metric_, species, group, unit_}, WindowMean{curve_window_s}});
  part->has_times = part->has_times || time_s;
  part->mean.add(time_s.value_or(0.0), value);
}

void SampledMetric::finish(const std::string& who, const std::string& where, RunMetrics& result,
                           std::vector<std::string>& remarks) const {
  for (const auto& [name, mean, has_times] : parts_) {
    if (std::ranges::find(result.measurements, name, &Measurement::name) != result.measurements.end()) {
      throw std::invalid_argument{who + ": trophic has a metric of this name; choose another"};
    }
    if (!mean.mean()) remarks.push_back(where + ": " + metric_ + " has no value; the run is left out of its mean");
    result.measurements.push_back({name, mean.mean(), {}});
    if (has_times) result.curves.push_back({name, "", mean.series()});
  }
}

}  // namespace trophic::analysis
