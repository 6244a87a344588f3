// SPDX-License-Identifier: MIT
// The grid of a sweep: its cells, what varies between them, and which of their runs belong together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/replicates/sweep/plan_file.hpp>
#include <trophic/support/json.hpp>
#include <utility>
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

/// What varies between cells.
struct Axis {
  std::string name;                 ///< a setting's path, rule_table or engine
  std::vector<std::string> values;  ///< one a cell, in their order; empty where a cell does not have the setting
};

struct SweepGrid {
  std::vector<GridCell> cells;  ///< by their numbers
  std::vector<Axis> axes;
  [[nodiscard]] const GridCell* find(std::size_t number) const {
    const auto found = std::ranges::find(cells, number, &GridCell::number);
    return found == cells.end() ? nullptr : &*found;
  }
};

namespace detail {

/// A setting as a cell of a table.
[[nodiscard]] inline std::string setting_text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : json_text(value);
}

[[nodiscard]] inline std::string value_on(const sweep::PlannedRun& run, std::string_view axis) {
  if (axis == "rule_table") return run.rule_table;
  if (axis == "engine") return run.engine;
  const auto found = run.settings.find(std::string{axis});
  return found == run.settings.end() ? "" : setting_text(*found);
}

}  // namespace detail

/// The grid of a plan. Axes: rule_table, engine, then settings in the order in which the plan names them; only those in which
/// cells differ.
[[nodiscard]] inline SweepGrid grid_of(std::span<const sweep::PlannedRun> plan) {
  std::map<std::size_t, GridCell> cells;
  std::map<std::pair<std::size_t, std::size_t>, GridReplicate> replicates;
  std::vector<std::string> names{"rule_table", "engine"};
  std::set<std::string> known;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const sweep::PlannedRun& run = plan[i];
    cells.try_emplace(run.cell, GridCell{run.cell, i, {}});
    GridReplicate& replicate = replicates[{run.cell, run.replicate}];
    replicate.seed = run.seed;
    (run.shadow ? replicate.shadow : replicate.run) = i;
    for (const auto& setting : run.settings.items()) {
      if (known.insert(setting.key()).second) names.push_back(setting.key());
    }
  }
  SweepGrid grid;
  for (const auto& [place, replicate] : replicates) cells.at(place.first).replicates.push_back(replicate);
  for (auto& [number, cell] : cells) grid.cells.push_back(std::move(cell));
  for (const std::string& name : names) {
    Axis axis{name, {}};
    for (const GridCell& cell : grid.cells) axis.values.push_back(detail::value_on(plan[cell.first], name));
    if (std::ranges::adjacent_find(axis.values, std::ranges::not_equal_to{}) != axis.values.end()) {
      grid.axes.push_back(std::move(axis));
    }
  }
  return grid;
}

/// Whether the replicates of two cells are compared seed by seed: all seeds of the smaller one are in the other. If they have
/// none in common their runs are independent. Throws std::invalid_argument, naming both cells, for seeds of which only some are
/// in common.
[[nodiscard]] inline bool is_paired(const GridCell& a, const GridCell& b) {
  std::set<std::uint64_t> seeds;
  for (const GridReplicate& replicate : a.replicates) seeds.insert(replicate.seed);
  const auto in_a = [&](const GridReplicate& replicate) { return seeds.contains(replicate.seed); };
  const auto common = static_cast<std::size_t>(std::ranges::count_if(b.replicates, in_a));
  const std::size_t fewer = std::min(a.replicates.size(), b.replicates.size());
  if (common != 0 && common != fewer) {
    throw std::invalid_argument{"cell " + std::to_string(b.number) + " has " + std::to_string(common) + " of " +
                                std::to_string(fewer) + " seeds in common with cell " + std::to_string(a.number) +
                                ": must be all, to be compared seed by seed, or none"};
  }
  return common != 0;
}

}  // namespace trophic::analysis
