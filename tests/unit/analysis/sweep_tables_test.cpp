// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/sweep_tables.hpp>
#include <trophic/support/whole_file.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

/// Two cells of six replicates with shadows, of which one run is missing.
struct Tables : test::TemporaryFolder {
  SweepRuns sweep;
  SweepValues values;

  Tables() {
    sweep.plan = test::plan_of({.cells = 2, .replicates = 6, .with_shadow = true});
    sweep.grid = grid_of(sweep.plan);
    sweep.is_there.assign(sweep.plan.size(), true);
    sweep.is_there[5] = false;
    values = test::values_of_plan(sweep.plan, test::velocity, [](const sweep::PlannedRun& run) {
      return static_cast<double>(run.cell) + (run.shadow ? 0.0 : 0.5 * static_cast<double>(run.replicate));
    });
    values.of_run[5].clear();
  }
  [[nodiscard]] std::string read(const std::string& name) const { return read_whole_file(path() / name); }
};

}  // namespace

TEST_CASE("cells.csv has a column for each setting that varies, and counts what was measured") {
  Tables tables;
  write_cells(tables.path() / "cells.csv", tables.sweep);
  CHECK(tables.read("cells.csv") ==
        "cell,rule_table,engine,runs,runs_planned,shadow_runs,until_s,x.y\n"
        "0,paper,kinematic,5,6,6,6000,0.0\n"
        "1,paper,kinematic,6,6,6,6000,0.5\n");
  write_cells(tables.path() / "cut.csv", tables.sweep, 300.0);
  CHECK(tables.read("cut.csv").find("0,paper,kinematic,5,6,6,300,0.0\n") != std::string::npos);
}

TEST_CASE("runs.csv has a row for each value, and none for a run that is missing") {
  Tables tables;
  write_runs(tables.path() / "runs.csv", tables.sweep, tables.values);
  const std::string text = tables.read("runs.csv");
  CHECK(text.starts_with("run,cell,replicate,shadow,seed,metric,species,group,value\n0,0,0,0,100,velocity,prey,all,0\n"));
  CHECK(text.find("\n5,") == std::string::npos);
  CHECK(text.find("\n23,1,5,1,105,velocity,prey,all,1\n") != std::string::npos);
}

TEST_CASE("sweep_metrics.csv has means with intervals from six runs on, raw and over the shadow") {
  Tables tables;
  write_sweep_metrics(tables.path() / "sweep_metrics.csv", tables.sweep.grid, tables.values);
  const std::string text = tables.read("sweep_metrics.csv");
  CHECK(text.find("\n0,velocity,prey,all,m/s,5,1,0.790569415042094") != std::string::npos);
  CHECK(text.find(",,,6,0,5,1,,\n1,velocity,prey,all,m/s,6,2.25,") != std::string::npos);  // five pairs: no interval
  CHECK(text.find(",6,1,6,1.25,") != std::string::npos);
}

TEST_CASE("sweep_differences.csv has a row for each metric of each cell but the reference") {
  Tables tables;
  const std::array names{test::velocity};
  write_sweep_differences(tables.path() / "sweep_differences.csv", compare_cells(tables.sweep.grid, tables.values, 1, names), 1);
  const std::string text = tables.read("sweep_differences.csv");
  CHECK(text.find("\n0,1,velocity,prey,all,m/s,over_shadow,paired,5,5,1,1,0,") != std::string::npos);
}
