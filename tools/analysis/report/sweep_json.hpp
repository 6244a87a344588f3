// SPDX-License-Identifier: MIT
// Results of a sweep for machines: summary.json.
#pragma once

#include <cstddef>
#include <span>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/analysis/report/cell_differences.hpp>
#include <trophic/support/json.hpp>

namespace trophic::analysis {

/// Results that no table has: the grid, missing runs, the correction of comparisons, significant differences, and the answer to
/// --difference. A value that could not be computed is null.
[[nodiscard]] Json sweep_json(const SweepRuns& sweep, const CellDifferences& differences, std::size_t reference,
                              std::span<const RunsForDifference> answers);

}  // namespace trophic::analysis
