// SPDX-License-Identifier: MIT
// The grid of a sweep: its cells, what varies between them, and which of their runs belong together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tools/sweep/plan_file.hpp>
#include <vector>

namespace trophic::analysis {

/// A replicate of a cell: places in the plan of the run and of its shadow.
struct GridReplicate {
  std::uint64_t seed = 0;
  std::optional<std::size_t> run;
  std::optional<std::size_t> shadow;
};

/// A point of the grid.
struct GridCell {
  std::size_t number = 0;
  std::size_t first = 0;                  ///< place in the plan of one of its runs: all have one rule table, engine and settings
  std::vector<GridReplicate> replicates;  ///< by their numbers
};

/// A setting that varies between cells.
struct Axis {
  std::string name;                 ///< a setting's path, rule_table or engine
  std::vector<std::string> values;  ///< one a cell, in their order; empty where a cell does not have the setting
};

struct SweepGrid {
  std::vector<GridCell> cells;  ///< by their numbers
  std::vector<Axis> axes;
  [[nodiscard]] const GridCell* find(std::size_t number) const;
};

/// The grid of a plan. Axes: rule_table, engine, then settings in the order in which the plan names them; only those in which
/// cells differ.
[[nodiscard]] SweepGrid grid_of(std::span<const sweep::PlannedRun> plan);

/// Whether the replicates of two cells are compared seed by seed: all seeds of the smaller one are in the other. If they have
/// none in common their runs are independent. Throws std::invalid_argument, naming both cells, for seeds of which only some are
/// in common.
[[nodiscard]] bool is_paired(const GridCell& a, const GridCell& b);

}  // namespace trophic::analysis
