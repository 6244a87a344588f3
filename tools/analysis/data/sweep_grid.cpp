// SPDX-License-Identifier: MIT
// Definitions of sweep_grid.hpp.
#include <tools/analysis/data/sweep_grid.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <trophic/support/json.hpp>

namespace trophic::analysis {

const GridCell* SweepGrid::find(std::size_t number) const {
  const auto found = std::ranges::find(cells, number, &GridCell::number);
  return found == cells.end() ? nullptr : &*found;
}

namespace {

/// A setting as a cell of a table.
std::string setting_text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : json_text(value);
}

std::string value_on(const sweep::PlannedRun& run, std::string_view axis) {
  if (axis == "rule_table") return run.rule_table;
  if (axis == "engine") return run.engine;
  const auto found = run.settings.find(std::string{axis});
  return found == run.settings.end() ? "" : setting_text(*found);
}

}  // namespace

SweepGrid grid_of(std::span<const sweep::PlannedRun> plan) {
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
    for (const GridCell& cell : grid.cells) axis.values.push_back(value_on(plan[cell.first], name));
    if (std::ranges::adjacent_find(axis.values, std::ranges::not_equal_to{}) != axis.values.end()) {
      grid.axes.push_back(std::move(axis));
    }
  }
  return grid;
}

bool is_paired(const GridCell& a, const GridCell& b) {
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
