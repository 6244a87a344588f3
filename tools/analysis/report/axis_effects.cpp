// SPDX-License-Identifier: MIT
// Definitions of axis_effects.hpp.
#include <tools/analysis/report/axis_effects.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <tools/analysis/report/swaps.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <utility>

namespace trophic::analysis {

namespace {

/// Two cells that differ in one axis alone: places in the grid, the reference value's first.
using CellPair = std::pair<std::size_t, std::size_t>;

/// The pairs of cells with an axis at `reference` and at `value`, all other axes alike.
std::vector<CellPair> pairs_along(const SweepGrid& grid, const Axis& axis, const std::string& reference,
                                  const std::string& value) {
  const auto rest_of = [&](std::size_t cell) {
    std::vector<std::string> rest;
    for (const Axis& other : grid.axes) {
      if (&other != &axis) rest.push_back(other.values[cell]);
    }
    return rest;
  };
  std::map<std::vector<std::string>, std::size_t> at_reference;
  for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
    if (axis.values[cell] == reference) at_reference[rest_of(cell)] = cell;
  }
  std::vector<CellPair> pairs;
  for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
    if (axis.values[cell] != value) continue;
    const auto found = at_reference.find(rest_of(cell));
    if (found != at_reference.end()) pairs.emplace_back(found->second, cell);
  }
  return pairs;
}

/// The mean over cells by seed, of those seeds that have a value in all of them.
std::map<std::uint64_t, double> means_by_seed(std::span<const std::map<std::uint64_t, double>* const> cells) {
  std::map<std::uint64_t, double> means;
  for (const auto& entry : *cells.front()) {
    const std::uint64_t seed = entry.first;
    double sum = 0.0;
    const bool in_all = std::ranges::all_of(cells, [&](const auto* cell) {
      const auto found = cell->find(seed);
      if (found == cell->end()) return false;
      sum += found->second;
      return true;
    });
    if (in_all) means[seed] = sum / static_cast<double>(cells.size());
  }
  return means;
}

}  // namespace

std::vector<AxisEffect> axis_effects(const SweepGrid& grid, const SweepValues& values, std::size_t reference,
                                     std::span<const MetricName> names) {
  const GridCell& base = *grid.find(reference);
  const auto place = static_cast<std::size_t>(&base - grid.cells.data());
  if (!std::ranges::all_of(grid.cells, [&](const GridCell& cell) { return is_paired(base, cell); })) return {};
  std::vector<AxisEffect> effects;
  for (const MetricName& name : names) {
    std::vector<CellValues> of_cell;
    for (const GridCell& cell : grid.cells) of_cell.push_back(cell_values(cell, values, values.place_of(name)));
    for (const Axis& axis : grid.axes) {
      std::vector<std::string> done{axis.values[place]};
      for (const std::string& value : axis.values) {
        if (std::ranges::find(done, value) != done.end()) continue;
        done.push_back(value);
        const auto pairs = pairs_along(grid, axis, axis.values[place], value);
        if (pairs.empty()) continue;
        const bool over = needs_shadow(name) && std::ranges::all_of(pairs, [&](const CellPair& pair) {
                            return !of_cell[pair.first].over_shadow.empty() && !of_cell[pair.second].over_shadow.empty();
                          });
        const auto kind = over ? &CellValues::over_shadow : &CellValues::raw;
        std::vector<const std::map<std::uint64_t, double>*> here;
        std::vector<const std::map<std::uint64_t, double>*> there;
        for (const auto& [at_reference, at_value] : pairs) {
          here.push_back(&(of_cell[at_reference].*kind));
          there.push_back(&(of_cell[at_value].*kind));
        }
        const auto before = means_by_seed(here);
        const auto after = means_by_seed(there);
        AxisEffect effect{axis.name, value, axis.values[place], name, over, pairs.size(), 0, {}, {}, {}};
        std::vector<double> from;
        std::vector<double> to;
        std::vector<double> differences;
        for (const auto& [seed, mean] : before) {
          const auto other = after.find(seed);
          if (other == after.end()) continue;
          from.push_back(mean);
          to.push_back(other->second);
          differences.push_back(other->second - mean);
        }
        effect.seeds = differences.size();
        effect.mean = mean_of(to);
        effect.mean_reference = mean_of(from);
        effect.difference = difference_of(mean_of(differences), contrast({{1.0, differences}}));
        effects.push_back(std::move(effect));
      }
    }
  }
  std::vector<Difference*> together;
  for (AxisEffect& effect : effects) together.push_back(&effect.difference);
  adjust_together(together);
  return effects;
}

}  // namespace trophic::analysis
