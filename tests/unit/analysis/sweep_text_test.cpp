// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <sstream>
#include <string>
#include <tools/analysis/report/sweep_text.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

const std::array names{test::hunger};

struct Printed {
  SweepRuns sweep;
  CellDifferences differences;

  explicit Printed(const test::PlanShape& shape, double per_cell) {
    sweep.plan = test::plan_of(shape);
    sweep.grid = grid_of(sweep.plan);
    sweep.is_there.assign(sweep.plan.size(), true);
    const auto value = [&](const sweep::PlannedRun& run) {
      return static_cast<double>(run.cell) * (per_cell + (run.replicate % 2 == 0 ? 0.5 : -0.5));
    };
    differences = compare_cells(sweep.grid, test::values_of_plan(sweep.plan, test::hunger, value), 0, names);
  }
  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    print_sweep(out, sweep, differences, 0);
    print_cell_differences(out, sweep.grid, differences);
    return out.str();
  }
  [[nodiscard]] bool says(const std::string& part) const { return text().find(part) != std::string::npos; }
};

}  // namespace

TEST_CASE("print_sweep: cells -> what was compared and what is significant") {
  const Printed printed{{.cells = 3, .replicates = 6}, 10.0};
  CAPTURE(printed.text());
  CHECK(printed.says("sweep of 3 cells, 18 runs of 6000 s\naxis x.y: 0.0, 0.5, 1.0\nreference: cell 0 (y 0.0)\n"));
  CHECK(printed.says("2 comparisons with it, seed by seed; p corrected for all of them (Holm)"));
  CHECK(printed.says("hunger predator"));
  CHECK(printed.says("2/2    +20.0 [+18.6, +21.4]"));
  CHECK(printed.says("2 (y 1.0)\n"));
  CHECK_FALSE(printed.says("inconclusive"));
}

TEST_CASE("print_sweep: no significant comparison -> inconclusive, not absent") {
  const Printed printed{{.cells = 3, .replicates = 6, .paired = false}, 0.1};
  CAPTURE(printed.text());
  CHECK(printed.says("as independent sets (other seeds in each cell)"));
  CHECK(printed.says("no comparison is significant\ninconclusive: 2 of 2 comparisons; this does not show equality"));
  CHECK(printed.says("inconclusive in every cell: 1 metric: hunger predator\n"));
  CHECK_FALSE(printed.says("no effect"));
}

TEST_CASE("print_named_metrics: one line for each metric of each cell, with the runs that an inconclusive one needs") {
  const auto named = [](double per_cell) {
    const Printed printed{{.cells = 3, .replicates = 6}, per_cell};
    std::ostringstream out;
    print_named_metrics(out, printed.sweep.grid, printed.differences);
    return out.str();
  };
  CHECK(named(10.0).find("hunger predator  1 (y 0.5)  10.0  0.0        +10.0 [+9.4, +10.6]   <0.001") != std::string::npos);
  const std::string open = named(0.1);
  CHECK(open.find("runs needed\n") != std::string::npos);
  CHECK(open.find("  6+6   ") != std::string::npos);
}

TEST_CASE("too few runs are said, and a cell alone has nothing to be compared with") {
  const Printed few{{.cells = 2, .replicates = 5}, 10.0};
  CHECK(few.says("too few runs for a test in 1 of them: 6 in each cell are needed"));
  const Printed alone{{.cells = 1, .replicates = 6}, 10.0};
  CHECK(alone.text() == "sweep of 1 cell, 6 runs of 6000 s\nreference: cell 0\none cell alone: there is nothing to compare\n");
}

TEST_CASE("axes that end alike keep their paths, and unset values are named") {
  std::vector<Axis> axes{{"a.sd", {"1", ""}}, {"b.sd", {"2", "2"}}};
  CHECK(analysis::detail::axis_title(axes, axes[0]) == "a.sd");
  CHECK(analysis::detail::values_on(axes[0]) == "1, unset");
  const SweepGrid grid{{{0, 0, {}}, {1, 1, {}}}, axes};
  CHECK(analysis::detail::cell_title(grid, 1) == "a.sd unset, b.sd 2");
}

TEST_CASE("sweep text: power of a difference -> a sentence with the number of replicates") {
  const Printed printed{{.cells = 2, .replicates = 6}, 10.0};
  std::ostringstream out;
  print_runs_for_difference(out, runs_for_difference(printed.differences, 0.5), printed.differences);
  CHECK(out.str().starts_with(
      "a difference of 0.5 in hunger predator needs 12 replicates a cell (12 to 12, cell by cell) for 80 % power\n"));
  CHECK(out.str().find("at the level of one of 1 comparison, 0.05;") != std::string::npos);
}
