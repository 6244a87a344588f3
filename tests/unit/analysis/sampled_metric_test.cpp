// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <tools/analysis/metrics/sampled_metric.hpp>
#include <vector>

namespace {

using namespace trophic::analysis;

struct Finished {
  RunMetrics metrics;
  std::vector<std::string> remarks;
};

Finished finished(const SampledMetric& sampled) {
  Finished result;
  sampled.finish("metric x", "runs/a", result.metrics, result.remarks);
  return result;
}

}  // namespace

TEST_CASE("sampled metric: samples of two species -> a mean each, in the order in which they come") {
  SampledMetric sampled{"x", "m", false};
  sampled.add("prey", "all", {}, 1.0);
  sampled.add("predator", "all", {}, 5.0);
  sampled.add("prey", "all", {}, 4.0);
  const Finished found = finished(sampled);
  REQUIRE(found.metrics.measurements.size() == 2);
  CHECK(found.metrics.measurements[0].name == MetricName{"x", "prey", "all", "m"});
  CHECK(*found.metrics.measurements[0].value == 2.5);
  CHECK(*found.metrics.measurements[1].value == 5.0);
  CHECK(found.metrics.curves.empty());
  CHECK(found.remarks.empty());
}

TEST_CASE("sampled metric: samples with times -> windows of 200 s, without those that have no value") {
  SampledMetric sampled{"x", "1", true};
  sampled.add("", "all", 0.0, 1.0);
  sampled.add("", "all", 200.0, 3.0);
  sampled.add("", "all", 201.0, {});
  sampled.add("", "all", 400.0, 8.0);
  const Finished found = finished(sampled);
  CHECK(*found.metrics.measurements[0].value == 4.0);
  REQUIRE(found.metrics.curves.size() == 1);
  REQUIRE(found.metrics.curves[0].points.size() == 2);
  CHECK(found.metrics.curves[0].points[1].time_s == 400.0);
  CHECK(*found.metrics.curves[0].points[0].value == 2.0);
  CHECK(*found.metrics.curves[0].points[1].value == 8.0);
}

TEST_CASE("sampled metric: no sample of one without species -> a measurement without a value, and a remark") {
  const Finished one = finished(SampledMetric{"x", "1", true});
  REQUIRE(one.metrics.measurements.size() == 1);
  CHECK_FALSE(one.metrics.measurements[0].value);
  CHECK(one.remarks == std::vector<std::string>{"runs/a: x has no value; the run is left out of its mean"});
  CHECK(finished(SampledMetric{"x", "1", false}).metrics.measurements.empty());
}

TEST_CASE("sampled metric: a name that the run has already -> error that names the metric") {
  SampledMetric sampled{"x", "1", true};
  Finished result;
  result.metrics.measurements.push_back({{"x", "", "all", "1"}, 1.0, {}});
  CHECK_THROWS_WITH_AS(sampled.finish("metric x", "runs/a", result.metrics, result.remarks),
                       doctest::Contains("metric x: trophic has a metric of this name"), std::invalid_argument);
}

TEST_CASE("sampled metric: more species and groups than there can be -> error") {
  SampledMetric sampled{"x", "m", false};
  for (int i = 0; i < 1000; ++i) sampled.add(std::to_string(i), "all", {}, 1.0);
  sampled.add("7", "all", {}, 1.0);
  CHECK_THROWS_AS(sampled.add("1000", "all", {}, 1.0), std::invalid_argument);
}
