// SPDX-License-Identifier: MIT
// Sentences of an analysis page about a set of runs: question, findings, rows of the table, rules, commands.
#pragma once

#include <tools/analysis/metrics/run_set.hpp>
#include <tools/trophic/analysis_page.hpp>

namespace trophic::command {

/// Adds all of it. `command`: the command line that makes the page.
void describe(AnalysisPage& page, std::span<const analysis::ShadowedSet> sets, const std::string& command);

}  // namespace trophic::command
