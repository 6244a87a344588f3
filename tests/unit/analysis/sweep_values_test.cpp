// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <unit/reading/rows.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("metrics of several food webs are named once, in the order of the first") {
  const FoodWeb one{{"prey"}, {}};
  const auto both = metric_names(std::vector{test::prey_and_predators, one, test::prey_and_predators});
  CHECK(both == metric_names(std::vector{test::prey_and_predators}));
  CHECK(metric_names(std::vector{one, test::prey_and_predators}).size() == both.size());
  CHECK(both.front() == MetricName{"attribution_caught", "prey", "all", "1"});
}

TEST_CASE("sweep values: any number of jobs -> the same values, and none for missing runs") {
  const test::TemporaryFolder folder;
  const auto plan = test::plan_of({.cells = 2, .replicates = 3});
  test::write_sweep(folder.path(), plan);
  std::filesystem::remove_all(folder.path() / plan[1].folder);
  const SweepRuns sweep = read_sweep(folder.path());
  const SweepValues values = measure_sweep(sweep);
  CHECK(measure_sweep(sweep, {.jobs = 3}).of_run == values.of_run);
  const std::size_t caught = values.place_of({"attribution_caught", "prey", "all", "1"});
  CHECK(values.value(0, caught) == 1.0);
  CHECK(values.of_run[1].empty());
  CHECK_FALSE(values.value(1, caught));
  CHECK_FALSE(values.value({}, caught));
  const std::size_t population = values.place_of({"population", "prey", "all", "1"});
  CHECK(values.value(0, population) == 0.5);
  CHECK(measure_sweep(sweep, {.until_s = 1.0}).value(0, population) == 1.0);
}

TEST_CASE("a run that cannot be read as a whole is an error with its number") {
  const test::TemporaryFolder folder;
  const auto plan = test::plan_of({.cells = 2, .replicates = 3});
  test::write_sweep(folder.path(), plan);
  std::filesystem::remove(folder.path() / plan[4].folder / "agents.csv");
  const SweepRuns sweep = read_sweep(folder.path());
  const std::string why = test::message_of<std::invalid_argument>([&] { static_cast<void>(measure_sweep(sweep, {.jobs = 2})); });
  CHECK(why.starts_with("run 4: "));
  CHECK(why.find("cell-1/replicate-1/agents.csv: cannot be read") != std::string::npos);
}

TEST_CASE("a cell's values stand by seed, over their shadows where both have one") {
  const auto plan = test::plan_of({.cells = 1, .replicates = 2, .with_shadow = true});
  SweepValues values = test::values_of_plan(plan, test::velocity, [](const sweep::PlannedRun& run) {
    return (run.shadow ? 1.0 : 3.0) + static_cast<double>(run.replicate);
  });
  values.of_run[3][0].reset();
  const CellValues of = cell_values(grid_of(plan).cells[0], values, 0);
  CHECK(of.raw == std::map<std::uint64_t, double>{{100, 3.0}, {101, 4.0}});
  CHECK(of.shadow == std::map<std::uint64_t, double>{{100, 1.0}});
  CHECK(of.over_shadow == std::map<std::uint64_t, double>{{100, 2.0}});
}
