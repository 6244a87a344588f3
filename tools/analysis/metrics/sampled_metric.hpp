// SPDX-License-Identifier: MIT
// A metric that is given as samples, each of a time, a species and a group.
#pragma once

#include <tools/analysis/metrics/measurement.hpp>
#include <utility>

namespace trophic::analysis {

/// The means of samples over a run, one for each species and group in the order in which they first come, and their curves in
/// windows of 200 s.
class SampledMetric {
 public:
  /// `is_one`: samples have neither species nor group, so there is a measurement even if there is no sample.
  SampledMetric(std::string metric, std::string unit, bool is_one);

  /// Without a time a sample has no place in the curve; without a value it counts for nothing. Throws
  /// std::invalid_argument if there are more than 1000 species and groups.
  void add(const std::string& species, const std::string& group, std::optional<double> time_s, std::optional<double> value);

  /// Adds them to a run's metrics. A mean without any value gets a remark that begins with `where`. Throws
  /// std::invalid_argument, beginning with `who`, if the run has a metric of this name.
  void finish(const std::string& who, const std::string& where, RunMetrics& result, std::vector<std::string>& remarks) const;

 private:
  struct Part {
    MetricName name;
    WindowMean mean;
    bool has_times = false;
  };

  std::string metric_;
  std::string unit_;
  std::vector<Part> parts_;
};

}  // namespace trophic::analysis
