// SPDX-License-Identifier: MIT
// Sentences of an analysis page about a set of runs: question, findings, rows of the table, rules, commands.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <tools/analysis/metrics/run_set.hpp>
#include <tools/trophic/analysis_page.hpp>

namespace trophic::command {

/// Adds all of it. `command`: the command line that makes the page; `scratch`: a file that may be written and is removed. Throws
/// std::runtime_error if it cannot be written.
void describe(AnalysisPage& page, std::span<const analysis::ShadowedSet> sets, const std::string& command,
              const std::filesystem::path& scratch);

}  // namespace trophic::command
