// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <sstream>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/axis_rows.hpp>
#include <trophic/support/whole_file.hpp>
#include <unit/analysis/sweep_grids.hpp>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("sweep_effects.csv and its summary say what is significant") {
  const auto plan = test::plan_of_two_axes(6);
  const auto values = test::values_of_plan(plan, test::hunger, [](const sweep::PlannedRun& run) {
    return 10.0 * static_cast<double>(run.cell / 2) + static_cast<double>(run.replicate % 2) * static_cast<double>(run.cell);
  });
  const std::array names{test::hunger};
  const auto effects = axis_effects(grid_of(plan), values, 0, names);
  const test::TemporaryFolder folder;
  write_axis_effects(folder.path() / "sweep_effects.csv", effects);
  const std::string text = read_whole_file(folder.path() / "sweep_effects.csv");
  CHECK(text.starts_with("axis,value,reference,metric,species,group,unit,compared,settings,seeds,mean,"));
  CHECK(text.find("\na,1,0,hunger,predator,all,ticks,raw,2,6,11.25,0.25,11,") != std::string::npos);
  std::ostringstream out;
  print_axis_effects(out, effects);
  CHECK(out.str().find("of 3 effects of an axis are significant (Holm); the largest of each:") != std::string::npos);
  CHECK(out.str().find("0 -> 2\n") != std::string::npos);
}
