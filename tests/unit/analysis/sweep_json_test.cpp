// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <tools/analysis/report/sweep_json.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("the summary has the grid, what is missing, the correction, what is significant and what was asked") {
  SweepRuns sweep;
  sweep.plan = test::plan_of({.cells = 3, .replicates = 6});
  sweep.grid = grid_of(sweep.plan);
  sweep.missing = {"run 4 (cell-0/replicate-4): no such folder"};
  const std::array names{test::hunger};
  const auto values = test::values_of_plan(sweep.plan, test::hunger, [](const sweep::PlannedRun& run) {
    return run.cell == 1 ? 10.0 + static_cast<double>(run.replicate) : 0.0;
  });
  const auto differences = compare_cells(sweep.grid, values, 0, names);
  const auto json = sweep_json(sweep, differences, 0, runs_for_difference(differences, 5.0));
  CHECK(json["cells"] == 3);
  CHECK(json["axes"][0]["name"] == "x.y");
  CHECK(json["axes"][0]["values"][2] == "1.0");
  CHECK(json["missing"].size() == 1);
  CHECK(json["comparisons"] == 1);
  CHECK(json["level"] == 0.05);
  REQUIRE(json["significant"].size() == 1);
  CHECK(json["significant"][0]["cell"] == 1);
  CHECK(json["significant"][0]["metric"] == "hunger");
  CHECK(json["significant"][0]["value"] == 12.5);
  CHECK(json["asked"][0]["runs"] == 6);
}
