// SPDX-License-Identifier: MIT
// Sweeps in memory and on the disk, made by hand.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <tools/sweep/plan_file.hpp>
#include <unit/reading/run_files.hpp>
#include <utility>
#include <vector>

namespace trophic::test {

inline const analysis::MetricName hunger{"hunger", "predator", "all", "ticks"};
inline const analysis::MetricName velocity{"velocity", "prey", "all", "m/s"};

struct PlanShape {
  std::size_t cells = 2;
  std::size_t replicates = 2;
  bool with_shadow = false;
  bool paired = true;
};

/// A plan whose cells differ in x.y; seeds count from 100.
inline std::vector<sweep::PlannedRun> plan_of(const PlanShape& shape) {
  std::vector<sweep::PlannedRun> plan;
  for (std::size_t cell = 0; cell < shape.cells; ++cell) {
    for (const bool shadow : {false, true}) {
      if (shadow && !shape.with_shadow) continue;
      for (std::size_t replicate = 0; replicate < shape.replicates; ++replicate) {
        sweep::PlannedRun run;
        run.index = plan.size();
        run.cell = cell;
        run.replicate = replicate;
        run.shadow = shadow;
        run.rule_table = "paper";
        run.engine = "kinematic";
        run.settings = {{"ecology.duration_s", 6000.0}, {"x.y", 0.5 * static_cast<double>(cell)}};
        run.seed = 100 + replicate + (shape.paired ? 0 : cell * shape.replicates);
        run.until_s = 6000.0;
        run.folder = "cell-" + std::to_string(cell) + (shadow ? "/shadow" : "") + "/replicate-" + std::to_string(replicate);
        run.fingerprint = "f" + std::to_string(cell) + (shadow ? "s" : "");
        plan.push_back(std::move(run));
      }
    }
  }
  return plan;
}

/// A grid of a = 0, 1, 2 and b = 0, 1; cells are numbered a first.
inline std::vector<sweep::PlannedRun> plan_of_two_axes(std::size_t replicates, bool with_shadow = false, bool paired = true) {
  auto plan = plan_of({.cells = 6, .replicates = replicates, .with_shadow = with_shadow, .paired = paired});
  for (sweep::PlannedRun& run : plan) run.settings = {{"a", run.cell / 2}, {"b", run.cell % 2}};
  return plan;
}

/// Values of one metric in every run of a plan.
inline analysis::SweepValues values_of_plan(const std::vector<sweep::PlannedRun>& plan, const analysis::MetricName& name,
                                            const std::function<double(const sweep::PlannedRun&)>& value) {
  analysis::SweepValues values{{name}, {}};
  for (const sweep::PlannedRun& run : plan) values.of_run.push_back({value(run)});
  return values;
}

/// FOLDER with the plan and a small run in each of its folders.
inline void write_sweep(const std::filesystem::path& folder, const std::vector<sweep::PlannedRun>& plan) {
  std::filesystem::create_directories(folder);
  std::ofstream{folder / "plan.jsonl"} << sweep::plan_text(plan);
  for (const sweep::PlannedRun& run : plan) {
    const std::string heredity = run.shadow ? "nothing_inherited" : "own_copy";
    const std::string text = manifest(run.fingerprint, static_cast<int>(run.seed));
    write_run(folder / run.folder, text.substr(0, text.size() - 1) + R"(, "rules": {"heredity": ")" + heredity + "\"}}");
  }
}

}  // namespace trophic::test
