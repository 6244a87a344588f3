// SPDX-License-Identifier: MIT
// --status: which runs of a sweep are done.
#pragma once

#include <tools/experiment/experiment_options.hpp>

namespace trophic::command {

/// Prints how many runs of the sweep in `options.out` are done, running, failed, interrupted and missing, and how
/// long the rest takes on one core. Changes nothing. Returns 0. Throws std::invalid_argument for a folder that is not a
/// sweep's.
[[nodiscard]] int sweep_status(const ExperimentOptions& options);

}  // namespace trophic::command
