// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <tools/analysis/report/sweep_rows.hpp>
#include <trophic/io/csv.hpp>
#include <unit/analysis/sweep_grids.hpp>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("a difference as a row, significant, inconclusive and untested") {
  CellDifference of;
  of.cell = 3;
  of.name = test::velocity;
  of.over_shadow = true;
  of.paired = true;
  of.runs = 8;
  of.runs_reference = 8;
  of.mean = 0.5;
  of.mean_reference = 0.25;
  of.difference = {.value = 0.25, .interval = Interval{0.125, 0.375}, .p = 0.001, .adjusted = 0.04};
  of.corrected = Interval{0.0625, 0.4375};
  of.hedges_g = 1.5;
  of.runs_needed = 12;
  of.detectable = 0.3125;
  SweepDifferenceRow row = row_of(of, 1);
  std::string text;
  io::append_row(text, row, FoodWeb{{}, {}});
  CHECK(
      text ==
      "3,1,velocity,prey,all,m/s,over_shadow,paired,8,8,0.5,0.25,0.25,0.125,0.375,0.0625,0.4375,0.001,0.04,yes,1.5,12,0.3125\n");
  of.difference.adjusted = 0.06;
  CHECK(row_of(of, 1).significant == "no");
  of.difference = {.value = 0.25, .interval = {}, .p = {}, .adjusted = {}};
  of.paired = false;
  of.over_shadow = false;
  row = row_of(of, 1);
  CHECK(row.significant.empty());
  CHECK_FALSE(row.lower);
  CHECK(row.design == "independent");
  CHECK(row.compared == "raw");
}
