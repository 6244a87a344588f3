// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <tools/analysis/metrics/own_metric.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <trophic/population/food_web.hpp>

namespace {

using namespace trophic::analysis;
using trophic::io::RunTables;
using trophic::io::Sample;

const trophic::FoodWeb web{{"prey", "predator"}, {{1, 0}}};

RunData run_of_600_s() {
  RunData run;
  run.manifest.folder = "runs/a";
  run.manifest.web = web;
  run.manifest.until_s = 600.0;
  run.agents = std::vector<trophic::io::AgentRow>(2);
  run.agents->at(0) = {.time_s = 0.0, .species = 0, .x_m = 3.0, .y_m = 4.0};
  run.agents->at(1) = {.time_s = 0.0, .species = 1, .x_m = 0.0, .y_m = 2.0};
  return run;
}

std::vector<Sample> from_centre(const RunTables& run) {
  std::vector<Sample> samples;
  for (const auto& robot : run.agents) {
    samples.push_back({.value = std::hypot(robot.x_m, robot.y_m), .time_s = robot.time_s, .species = robot.species});
  }
  return samples;
}

/// The error of a metric with one sample.
std::string error_of(const Sample& sample) {
  RunMetrics result;
  std::vector<std::string> remarks;
  const OwnMetric metric{.name = "odd", .unit = "1", .samples = [&](const RunTables&) { return std::vector{sample}; }};
  try {
    measure_own(metric, run_of_600_s(), result, remarks);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

std::string refusal_of(const OwnMetric& metric) {
  try {
    check_names({&web, 1}, {.metrics = {metric}}, {});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("measure_own: function of the tables -> a value for each species by its name, and a curve") {
  RunMetrics result;
  std::vector<std::string> remarks;
  measure_own({.name = "from_centre", .unit = "m", .samples = from_centre}, run_of_600_s(), result, remarks);
  REQUIRE(result.measurements.size() == 2);
  CHECK(result.measurements[0].name == MetricName{"from_centre", "prey", "all", "m"});
  CHECK(*result.measurements[0].value == 5.0);
  CHECK(result.measurements[1].name.species == "predator");
  CHECK(*result.measurements[1].value == 2.0);
  CHECK(result.curves.size() == 2);
  CHECK(remarks.empty());
}

TEST_CASE(
    "measure_own: NaN -> no value and a remark, all else that is not a sample of the run -> error that names metric and run") {
  CHECK(error_of({.value = 1.0, .time_s = 600.0}).empty());
  CHECK(error_of({.value = std::nan("")}).empty());
  CHECK(error_of({.value = std::numeric_limits<double>::infinity()}) ==
        "metric odd: runs/a: value = inf: must be finite, or NaN if there is none");
  CHECK(error_of({.value = 1.0, .time_s = 600.5}) == "metric odd: runs/a: time_s = 600.5: must be >= 0 and <= 600");
  CHECK(error_of({.value = 1.0, .time_s = std::nan("")}).ends_with("must be >= 0 and <= 600"));
  CHECK(error_of({.value = 1.0, .species = trophic::Species{2}}) == "metric odd: runs/a: species = 2: must be < 2");
  CHECK(error_of({.value = 1.0, .group = ""}).ends_with("group \"\": must be letters, digits and _"));
  RunMetrics result;
  std::vector<std::string> remarks;
  const auto nothing = [](const RunTables&) { return std::vector<Sample>{{.value = std::nan("")}}; };
  measure_own({.name = "odd", .unit = "1", .samples = nothing}, run_of_600_s(), result, remarks);
  CHECK_FALSE(result.measurements.at(0).value);
  CHECK(remarks == std::vector<std::string>{"runs/a: odd has no value; the run is left out of its mean"});
}

TEST_CASE("check_names: own metric with the name of a shipped one, of a column or without a word -> refused") {
  CHECK(refusal_of({.name = "from_centre", .unit = "m/s", .samples = from_centre}).empty());
  CHECK(refusal_of({.name = "hunger", .unit = "1", .samples = from_centre}) ==
        "metric hunger: trophic has a metric of this name; choose another");
  CHECK(refusal_of({.name = "a b", .unit = "1", .samples = from_centre}) == "metric a b: its name must be letters, digits and _");
  CHECK(refusal_of({.name = "a", .unit = "m,s", .samples = from_centre}).starts_with("metric a: unit \"m,s\""));
  CHECK(refusal_of({.name = "a", .unit = "1", .samples = {}}) == "metric a: has no function");
  const OwnMetric metric{.name = "close", .unit = "1", .samples = from_centre};
  const Measuring how{.columns = {own_column_of("crowd.csv:close")}, .metrics = {metric}};
  CHECK_THROWS_WITH_AS(check_names({&web, 1}, how, {}), doctest::Contains("metric close"), std::invalid_argument);
}

TEST_CASE("check_names: choices -> those of shipped and own metrics pass, others are refused with the nearest name") {
  const Measuring how{.metrics = {{.name = "from_centre", .unit = "m", .samples = from_centre}}};
  const std::array<std::string, 2> known{"from_centre:prey", "velocity:prey"};
  CHECK_NOTHROW(check_names({&web, 1}, how, known));
  const std::array<std::string, 1> unknown{"from_center"};
  CHECK_THROWS_WITH_AS(check_names({&web, 1}, how, unknown), doctest::Contains("did you mean from_centre?"),
                       std::invalid_argument);
}
