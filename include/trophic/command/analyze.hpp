// SPDX-License-Identifier: MIT
// The command `analyze`, in the program trophic and in programs that link trophic::analysis.
#pragma once

#include <string>
#include <trophic/command/option.hpp>
#include <trophic/command/selection.hpp>
#include <trophic/io/own_metric.hpp>

namespace trophic::command {

/// Metrics of runs, claims about them, and differences between two sets of them, with the own metrics of `program`, whose
/// rule tables `offer` has. Throws
/// std::invalid_argument for a metric whose name is taken or is not a word.
[[nodiscard]] Command analyze(const std::string& program = "trophic", const io::OwnMetrics& own_metrics = {},
                              const Offer& offer = {});

}  // namespace trophic::command
