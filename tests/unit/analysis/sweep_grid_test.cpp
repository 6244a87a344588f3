// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/analysis/data/sweep_grid.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("a plan's cells have their replicates, each with its shadow") {
  const SweepGrid grid = grid_of(test::plan_of({.cells = 3, .replicates = 2, .with_shadow = true}));
  REQUIRE(grid.cells.size() == 3);
  CHECK(grid.cells[1].number == 1);
  CHECK(grid.cells[1].first == 4);
  REQUIRE(grid.cells[1].replicates.size() == 2);
  CHECK(grid.cells[1].replicates[1].seed == 101);
  CHECK(grid.cells[1].replicates[1].run == 5);
  CHECK(grid.cells[1].replicates[1].shadow == 7);
  CHECK(grid.find(2)->number == 2);
  CHECK(grid.find(3) == nullptr);
}

TEST_CASE("axes are what differs between cells: rule tables, engines and settings, also those that only some cells have") {
  auto plan = test::plan_of({.cells = 2, .replicates = 1});
  SweepGrid grid = grid_of(plan);
  REQUIRE(grid.axes.size() == 1);
  CHECK(grid.axes[0].name == "x.y");
  CHECK(grid.axes[0].values == std::vector<std::string>{"0.0", "0.5"});
  plan[1].rule_table = "released";
  plan[1].settings["robot"] = "gecko";
  grid = grid_of(plan);
  REQUIRE(grid.axes.size() == 3);
  CHECK(grid.axes[0].name == "rule_table");
  CHECK(grid.axes[2].name == "robot");
  CHECK(grid.axes[2].values == std::vector<std::string>{"", "gecko"});
  CHECK(grid_of(test::plan_of({.cells = 1})).axes.empty());
}

TEST_CASE("cells are paired by seeds, all of them or none") {
  const auto paired = grid_of(test::plan_of({.cells = 2, .replicates = 3})).cells;
  CHECK(is_paired(paired[0], paired[1]));
  const auto independent = grid_of(test::plan_of({.cells = 2, .replicates = 3, .paired = false})).cells;
  CHECK_FALSE(is_paired(independent[0], independent[1]));
  GridCell more = paired[1];
  more.replicates.push_back({.seed = 7, .run = 9, .shadow = {}});
  CHECK(is_paired(paired[0], more));
  GridCell mixed = paired[1];
  mixed.replicates[0].seed = 7;
  CHECK(test::message_of<std::invalid_argument>([&] { static_cast<void>(is_paired(paired[0], mixed)); }) ==
        "cell 1 has 2 of 3 seeds in common with cell 0: must be all, to be compared seed by seed, or none");
}
