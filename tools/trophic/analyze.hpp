// SPDX-License-Identifier: MIT
// The command `analyze`, in the program trophic and in every experiment program.
#pragma once

#include <tools/command/offers.hpp>
#include <tools/command/option.hpp>

namespace trophic::command {

/// Metrics of runs, claims about them, and differences between two sets of them. Lineages are those of runs that `program` makes.
[[nodiscard]] Command analyze(const std::string& program, const Offer& offer);

}  // namespace trophic::command
