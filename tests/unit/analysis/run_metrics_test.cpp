// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <unit/reading/rows.hpp>

namespace {

using namespace trophic;
using namespace trophic::analysis;

RunData empty_run() {
  RunData run;
  run.manifest.web = test::prey_and_predators;
  run.manifest.half_side_m = 10.0;
  run.manifest.until_s = 6000.0;
  return run;
}

}  // namespace

TEST_CASE("an empty run has every metric, none with a value but what needs no data") {
  const auto metrics = measure_run(empty_run());
  for (const Measurement& measurement : metrics.measurements) {
    CAPTURE(measurement.name.metric);
    CHECK_FALSE(measurement.value);
  }
  const auto has = [&](const MetricName& name) {
    return std::ranges::find(metrics.measurements, name, &Measurement::name) != metrics.measurements.end();
  };
  CHECK(has({"attribution_caught", "prey", "all", "1"}));
  CHECK(has({"attribution_catchers", "predator", "all", "1"}));
  CHECK_FALSE(has({"attribution_caught", "predator", "all", "1"}));
  CHECK(has({"velocity", "prey", "inherited", "m/s"}));
  CHECK(has({"velocity_stored", "predator", "all", "m/s"}));
  CHECK(has({"ticks_at", "predator", "8", "1"}));
  CHECK_FALSE(has({"ticks_at", "prey", "8", "1"}));
  CHECK(has({"stuck", "all", "all", "1"}));
  for (const char* group : {"all", "random", "inherited", "active"}) {
    CAPTURE(group);
    for (const char* metric : {"velocity", "velocity_points", "velocity_stored"}) CHECK(has({metric, "prey", group, "m/s"}));
    CHECK(has({"wall_sticking", "predator", group, "1"}));
  }
  for (const char* group : {"all", "active"}) CHECK(has({"wall_sticking_gap", "prey-predator", group, "1"}));
  for (const char* group : {"inherited", "inherited_active"}) CHECK(has({"tag_symmetry", "prey+predator", group, "1"}));
}

TEST_CASE("only permuted tags are a null of the run itself, and what the paper compares with is marked as its own") {
  for (const Measurement& measurement : measure_run(empty_run()).measurements) {
    for (const Baseline& baseline : measurement.baselines) {
      CAPTURE(measurement.name.metric);
      CHECK((baseline.role == Role::null) == (baseline.name == "permuted_tags"));
      const bool is_papers = baseline.name == "two_thirds" || baseline.name == "uniform_pairs" ||
                             (baseline.name == "zero" && measurement.name.unit == "m/s");
      CHECK((baseline.role == Role::paper) == is_papers);
    }
  }
}

TEST_CASE("three species: each link of the food web is measured") {
  RunData run = empty_run();
  run.manifest.web = FoodWeb{{"grass", "sheep", "wolf"}, {{1, 0}, {2, 1}}};
  run.agents = {
      {test::robot(0, 0, 0, 9.5, 0), test::robot(0, 1, 1, 0, 0), test::robot(0, 2, 2, 0, 0, {}, Origin::inherited, -1)}};
  const auto metrics = measure_run(run);
  const auto value = [&](const MetricName& name) {
    return std::ranges::find(metrics.measurements, name, &Measurement::name)->value;
  };
  CHECK(*value({"wall_sticking_gap", "grass-sheep", "all", "1"}) == 1.0);
  CHECK(*value({"tag_symmetry", "grass+sheep", "inherited", "1"}) == 2.0);
  CHECK(*value({"tag_symmetry", "sheep+wolf", "inherited", "1"}) == 0.0);
}

TEST_CASE("a thinned table gives the same velocities from fewer starts, or none where no row stands 12 s later") {
  // A predator that walks 0.1 m a tick towards a prey at rest: 0.05 m/s, and neither is stuck.
  const auto every = [](std::int64_t ticks) {
    RunData run = empty_run();
    run.manifest.folder = "run";
    run.manifest.agents_every_ticks = ticks;
    run.agents.emplace();
    for (std::int64_t tick = 0; tick <= 60; tick += ticks) {
      run.agents->push_back(test::robot(tick, 0, test::prey, 0.0, 0.0));
      run.agents->push_back(test::robot(tick, 1, test::predator, 9.0 - 0.1 * static_cast<double>(tick), 0.0, 0));
    }
    return run;
  };
  const auto value = [](const RunData& run, const MetricName& name) {
    const auto metrics = measure_run(run);
    return std::ranges::find(metrics.measurements, name, &Measurement::name)->value;
  };
  const MetricName velocity{"velocity", "predator", "all", "m/s"};
  const MetricName stored{"velocity_stored", "predator", "all", "m/s"};
  const MetricName stuck{"stuck", "predator", "all", "1"};
  const MetricName walls{"wall_sticking", "prey", "all", "1"};
  CHECK(*value(every(1), stored) == doctest::Approx(0.05));
  for (const std::int64_t ticks : {1, 2, 3, 6}) {
    CAPTURE(ticks);
    CHECK(*value(every(ticks), velocity) == doctest::Approx(0.05));
    CHECK(value(every(ticks), stuck).has_value() == (ticks == 1));
    CHECK(value(every(ticks), stored).has_value() == (ticks == 1));
    CHECK(value(every(ticks), walls) == 0.0);
  }
  for (const std::int64_t ticks : {4, 5, 10}) {
    CAPTURE(ticks);
    CHECK_FALSE(value(every(ticks), velocity));
    CHECK(value(every(ticks), walls) == 0.0);
  }
  CHECK(*value(every(5), stuck) == 0.0);
  CHECK(lost_to_thinning(1).empty());
  CHECK(lost_to_thinning(3) ==
        "agents.csv: has the ticks that are multiples of 3: no velocity_stored, which needs every tick, no stuck, which needs "
        "rows 5 ticks apart");
  CHECK(lost_to_thinning(5) ==
        "agents.csv: has the ticks that are multiples of 5: no velocity_stored, which needs every tick, no velocity, which "
        "needs rows 6 ticks apart, no velocity_points, which needs rows 6 ticks apart");
}
