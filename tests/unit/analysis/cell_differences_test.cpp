// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/cell_differences.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;
using sweep::PlannedRun;

namespace {

const std::array hungers{test::hunger};
const std::array velocities{test::velocity};

/// Six seeds from 0.0 to 0.5 that every cell shares, and what cells add to them.
double by_seed(const PlannedRun& run) {
  return 0.1 * static_cast<double>(run.seed - 100);
}

}  // namespace

TEST_CASE("cells that share seeds are compared seed by seed, others as independent sets") {
  // What seeds have in common is large, and what the cell adds is nearly the same for each.
  const auto value = [](const PlannedRun& run) {
    const double jitter = run.replicate % 2 == 0 ? 0.01 : -0.01;
    return 10.0 * static_cast<double>(run.replicate) + static_cast<double>(run.cell) * (1.0 + jitter);
  };
  for (const bool paired : {true, false}) {
    CAPTURE(paired);
    const auto plan = test::plan_of({.cells = 3, .replicates = 6, .paired = paired});
    const auto differences = compare_cells(grid_of(plan), test::values_of_plan(plan, test::hunger, value), 0, hungers);
    REQUIRE(differences.all.size() == 2);
    CHECK(differences.comparisons == 2);
    CHECK(differences.level() == 0.025);
    const CellDifference& d = differences.all[1];
    CHECK(d.cell == 2);
    CHECK(d.paired == paired);
    CHECK(d.runs == 6);
    CHECK(*d.mean == doctest::Approx(27.0));
    CHECK(*d.difference.value == doctest::Approx(2.0));
    CHECK(d.difference.differs() == paired);
    CHECK(*d.hedges_g < 0.2);  // runs of one cell are far apart, whatever the pairs say
    CHECK(*d.runs_needed == (paired ? min_runs_for_test : *d.runs_needed));
    CHECK((*d.detectable < 2.0) == paired);
    CHECK(d.corrected->lower < d.difference.interval->lower);
    CHECK(d.corrected->upper > d.difference.interval->upper);
  }
}

TEST_CASE("paired differences by hand") {
  const auto plan = test::plan_of({.cells = 2, .replicates = 6});
  const std::array<double, 6> added{1.0, 2.0, 3.0, 1.0, 2.0, 3.0};
  const auto value = [&](const PlannedRun& run) { return by_seed(run) + (run.cell == 1 ? added[run.replicate] : 0.0); };
  const auto differences = compare_cells(grid_of(plan), test::values_of_plan(plan, test::hunger, value), 0, hungers);
  const CellDifference& d = differences.all.front();
  // Mean 2, variance 4/5: an error of sqrt(0.8 / 6), and t of 5 degrees of freedom at 97.5 % is 2.5706.
  CHECK(*d.difference.value == doctest::Approx(2.0));
  CHECK(d.difference.interval->lower == doctest::Approx(2.0 - 2.5706 * 0.36515).epsilon(1e-4));
  CHECK(d.corrected->lower == doctest::Approx(d.difference.interval->lower));  // of one comparison there is nothing to correct
  CHECK(d.scatter->variance == doctest::Approx(0.8));
  CHECK(d.scatter->freedom == 1.0);
}

TEST_CASE("any cell may be the reference, and it must be one") {
  const auto plan = test::plan_of({.cells = 3, .replicates = 6});
  const SweepGrid grid = grid_of(plan);
  const auto values = test::values_of_plan(plan, test::hunger, [](const PlannedRun& run) {
    return by_seed(run) * static_cast<double>(1 + run.cell) + static_cast<double>(run.cell);
  });
  const auto differences = compare_cells(grid, values, 1, hungers);
  REQUIRE(differences.all.size() == 2);
  CHECK(differences.all[0].cell == 0);
  CHECK(*differences.all[0].difference.value == doctest::Approx(-1.25));
  CHECK(test::message_of<std::invalid_argument>([&] { static_cast<void>(compare_cells(grid, values, 3, hungers)); }) ==
        "reference = 3: must be a cell of the sweep, 0 to 2");
}

TEST_CASE("what needs a shadow is compared over it, run by run, the rest is raw") {
  const auto plan = test::plan_of({.cells = 2, .replicates = 6, .with_shadow = true});
  const auto value = [](const PlannedRun& run) {
    const double of_cell = run.cell == 1 ? 5.0 : 0.0;  // the shadow has it, too
    const double jitter = run.replicate % 2 == 0 ? 0.1 : -0.1;
    return 3.0 * by_seed(run) + of_cell + (run.shadow ? 0.0 : jitter * static_cast<double>(run.cell));
  };
  const SweepGrid grid = grid_of(plan);
  const auto over = compare_cells(grid, test::values_of_plan(plan, test::velocity, value), 0, velocities);
  CHECK(over.all[0].over_shadow);
  CHECK(*over.all[0].difference.value == doctest::Approx(0.0));
  CHECK_FALSE(over.all[0].difference.differs());
  const auto raw = compare_cells(grid, test::values_of_plan(plan, test::hunger, value), 0, hungers);
  CHECK_FALSE(raw.all[0].over_shadow);
  CHECK(*raw.all[0].difference.value == doctest::Approx(5.0));
  CHECK(raw.all[0].difference.differs());
}

TEST_CASE("fewer than six runs have numbers and no conclusion, and count as comparisons") {
  const auto plan = test::plan_of({.cells = 3, .replicates = 5});
  const auto value = [](const PlannedRun& run) { return static_cast<double>(run.cell) * (10.0 + by_seed(run)); };
  const auto differences = compare_cells(grid_of(plan), test::values_of_plan(plan, test::hunger, value), 0, hungers);
  CHECK(differences.comparisons == 2);
  const CellDifference& d = differences.all.front();
  CHECK(*d.difference.value == doctest::Approx(10.2));
  CHECK(*d.runs_needed == min_runs_for_test);
  CHECK_FALSE(d.difference.p);
  CHECK_FALSE(d.difference.adjusted);
  CHECK_FALSE(d.corrected);
  CHECK_FALSE(d.detectable);
}

TEST_CASE("where nothing varies and nothing differs there is no comparison, and missing values leave their pair out") {
  const auto plan = test::plan_of({.cells = 3, .replicates = 7});
  auto values =
      test::values_of_plan(plan, test::hunger, [](const PlannedRun& run) { return run.cell == 2 ? by_seed(run) : 0.1; });
  values.of_run[16][0].reset();
  const auto differences = compare_cells(grid_of(plan), values, 0, hungers);
  CHECK(differences.comparisons == 1);
  CHECK_FALSE(differences.all[0].difference.p);
  CHECK_FALSE(differences.all[0].corrected);
  CHECK(differences.all[1].runs == 6);
  CHECK(differences.all[1].runs_reference == 6);
  CHECK(*differences.all[1].difference.p == *differences.all[1].difference.adjusted);
}

TEST_CASE("how many replicates a difference would need, by the scatter of the cells") {
  const auto plan = test::plan_of({.cells = 3, .replicates = 4});
  const auto value = [](const PlannedRun& run) { return static_cast<double>(run.cell) * (run.replicate % 2 == 0 ? 1.0 : -1.0); };
  const auto differences = compare_cells(grid_of(plan), test::values_of_plan(plan, test::hunger, value), 0, hungers);
  const auto answers = runs_for_difference(differences, 2.0);
  REQUIRE(answers.size() == 1);
  CHECK(answers[0].cells == 2);
  // Variances 4/3 and 16/3 between pairs.
  CHECK(answers[0].fewest == runs_for_power(2.0, {.variance = 4.0 / 3.0, .freedom = 1.0}, 0.025));
  CHECK(answers[0].runs == runs_for_power(2.0, {.variance = 10.0 / 3.0, .freedom = 1.0}, 0.025));
  CHECK(answers[0].most == runs_for_power(2.0, {.variance = 16.0 / 3.0, .freedom = 1.0}, 0.025));
}

TEST_CASE("cell differences: a metric that repeats another in all runs -> left out of those that are compared") {
  const MetricName all{"velocity", "prey", "all", "cm/s"};
  const MetricName active{"velocity", "prey", "active", "cm/s"};
  const MetricName other{"population", "prey", "all", "cm/s"};
  SweepValues values{{all, active, other},
                     {{1.0, 1.0, 4.0}, {2.0, 2.0, 4.5}, {5.0, 5.0, 3.0}, {}, {3.0, 3.0, 9.0}, {4.0, 4.0, 2.0}, {7.0, 7.0, 1.0}}};
  CHECK(distinct_metrics(values) == std::vector{all, other});
  values.of_run[4][1] = 3.5;
  CHECK(distinct_metrics(values) == values.names);
}
