// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/metrics/measurement.hpp>

using namespace trophic::analysis;

TEST_CASE("measurement: a metric over runs -> its computed values, of that name alone") {
  const MetricName metric{"stuck", "prey", "all", "1"};
  const MetricName other{"stuck", "predator", "all", "1"};
  const std::vector<RunMetrics> runs{{.measurements = {{other, 9.0, {}}, {metric, 1.0, {}}}, .curves = {}},
                                     {.measurements = {{metric, {}, {}}}, .curves = {}},
                                     {.measurements = {{metric, 3.0, {}}}, .curves = {}}};
  CHECK(values_of(runs, metric) == std::vector{1.0, 3.0});
  CHECK(values_of(runs, {"stuck", "prey", "random", "1"}).empty());
}
