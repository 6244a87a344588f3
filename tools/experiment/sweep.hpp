// SPDX-License-Identifier: MIT
// --sweep: a program's rule tables on its backends, over a grid of settings.
#pragma once

#include <tools/command/offers.hpp>
#include <tools/experiment/experiment_options.hpp>
#include <tools/sweep/plan_file.hpp>
#include <tools/sweep/sweep_file.hpp>
#include <vector>

namespace trophic::command {

/// Returns the plan of a sweep: its cells with the rule tables and backends of this program, each checked against the parameters
/// of its table. Throws std::invalid_argument "FILE: cell 3 (SETTINGS): ..." for the first cell that cannot be run, and for two
/// cells that are the same experiment. Cells and runs that are in `there`, the plan of the sweep's folder, have their numbers
/// there; others follow.
[[nodiscard]] std::vector<sweep::PlannedRun> plan_of(const sweep::SweepFile& file, const Offer& offer,
                                                     const std::vector<sweep::PlannedRun>& there = {});

/// Does the work of --sweep with --jobs, --run, --plan, --dry-run and --sbatch, and returns the exit code.
[[nodiscard]] int run_sweep(const ExperimentOptions& options, const Offer& offer);

}  // namespace trophic::command
