// SPDX-License-Identifier: MIT
// --plan: runs the list of runs in a file on a program's rule tables and backends.
#pragma once

#include <tools/command/offers.hpp>
#include <tools/experiment/experiment_options.hpp>

namespace trophic::command {

/// Does the work of --plan with --jobs, --run, --status and --describe, and returns the exit code.
[[nodiscard]] int run_plan(const ExperimentOptions& options, const Offer& offer);

}  // namespace trophic::command
