// SPDX-License-Identifier: MIT
// Hunters in the order in which they starve.
#pragma once

#include <trophic/population/view.hpp>

namespace trophic::death::starvation::choice::detail {

/// Returns the bodies of all hunters, or of one species, the hungriest (most ticks since birth or the last catch) first. In ties
/// the earlier born comes first.
[[nodiscard]] inline std::vector<BodyIndex> by_hunger(const View& view, OneSpecies only) {
  std::vector<BodyIndex> hunters;
  for (BodyIndex body = 0; body < view.robots.size(); ++body) {
    const Species species = view.robots[body].species;
    if (only ? species == *only : view.web.hunts(species)) hunters.push_back(body);
  }
  std::ranges::sort(hunters, [&](BodyIndex a, BodyIndex b) {
    const Individual& first = view.robots[a];
    const Individual& second = view.robots[b];
    return first.fed_tick != second.fed_tick ? first.fed_tick < second.fed_tick : first.id < second.id;
  });
  return hunters;
}

}  // namespace trophic::death::starvation::choice::detail
