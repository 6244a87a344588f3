// SPDX-License-Identifier: MIT
// The command `analyze`, in the program trophic and in every experiment program.
#pragma once

#include <tools/command/offers.hpp>
#include <tools/command/option.hpp>
#include <trophic/experiment/own_metric.hpp>

namespace trophic::command {

/// Metrics of runs, claims about them, and differences between two sets of them, with the metrics that `program` offers.
/// Throws std::invalid_argument for a metric whose name is taken or is not a word.
[[nodiscard]] Command analyze(const std::string& program, const Offer& offer);

}  // namespace trophic::command
