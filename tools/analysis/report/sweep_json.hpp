// SPDX-License-Identifier: MIT
// Results of a sweep for machines: summary.json.
#pragma once

#include <cstddef>
#include <span>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/analysis/report/cell_differences.hpp>
#include <trophic/support/json.hpp>

namespace trophic::analysis {

/// What the tables do not say: the grid, what is missing, how comparisons were corrected, what is decided, and what was asked.
/// null is what could not be computed.
[[nodiscard]] Json sweep_json(const SweepRuns& sweep, const CellDifferences& differences, std::size_t reference,
                              std::span<const RunsForDifference> answers);

}  // namespace trophic::analysis
