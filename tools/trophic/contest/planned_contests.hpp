// SPDX-License-Identifier: MIT
// The contests of some runs and their shadow: teams of each epoch, drawn from the runs' tables.
#pragma once

#include <tools/contest/contest_plan.hpp>
#include <tools/contest/contest_row.hpp>
#include <tools/reading/run_manifest.hpp>

namespace trophic::command::contests {

/// Runs that may be pooled, and their shadow.
struct Sets {
  std::vector<analysis::RunManifest> ours;
  std::vector<analysis::RunManifest> shadow;  ///< empty without one
  std::vector<analysis::RunManifest> panel;   ///< opponents of all runs; empty without them
  std::vector<std::string> remarks;
};

/// Reads the manifests. `shadow`: where the shadow lies; otherwise RUNS/shadow if there is one. Throws std::invalid_argument, a
/// sentence that names the runs, for runs that may not be pooled, a shadow that is none or has other replicates, and a food web
/// without hunters.
[[nodiscard]] Sets read_sets(std::span<const std::filesystem::path> runs, const std::optional<std::filesystem::path>& shadow,
                             bool any_build);

/// Adds a panel of opponents. Throws std::invalid_argument, a sentence, for runs that may not be pooled, of another table, or
/// without an end.
void add_panel(Sets& sets, const std::filesystem::path& panel, bool any_build);

struct Size {
  std::vector<double> epochs_s;           ///< empty: four, evenly over the run
  std::vector<contest::Against> against;  ///< none of own and others if there is a panel
  std::size_t teams = 2;
  std::size_t team_size = 0;  ///< 0: half of the run's robots
  double duration_s = 300.0;
  double reach_m = 1.0;
  std::uint64_t seed = 1;
};

/// Contests, each with its row but for the outcome.
struct Planned {
  contest::Plan plan;
  std::vector<contest::ContestRow> rows;  ///< in the order of the plan's matches
};

/// Throws std::invalid_argument, a sentence, if the runs cannot give these contests.
[[nodiscard]] Planned planned_contests(const Sets& sets, Size size);

}  // namespace trophic::command::contests
