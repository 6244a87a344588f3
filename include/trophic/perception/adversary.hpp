// SPDX-License-Identifier: MIT
// The adversary of an individual: the closest opponent that it perceives.
#pragma once

#include <trophic/perception/visibility/contract.hpp>

namespace trophic::perception {

/// The adversary of `self`: "the closest observable robot of the opposite species" (Sec. "Inputs"); with more than two species,
/// the closest robot of any species that eats its own or is eaten by it. `perceives(self, other)` is the run's Visibility rule.
/// At equal distances, the lower body index wins. `horizon` bounds what self perceives.   Random draws: those of the Visibility
/// rule.
template <std::predicate<BodyIndex, BodyIndex> Sees>
[[nodiscard]] std::optional<Sighting> adversary(BodyIndex self, const View& view, const Sees& perceives,
                                                const Horizon& horizon = {}) {
  const Species own = view.robots[self].species;
  const Search search{
      .within_m = horizon.within_m,
      .among = view.marks([&](Species other) { return view.web.opponents(own, other); }, horizon.tag, horizon.only_active)};
  const auto found = view.closest(
      self, [&](BodyIndex other) { return view.web.opponents(own, view.robots[other].species) && perceives(self, other); },
      search);
  if (!found) return std::nullopt;
  return Sighting{.self = self,
                  .adversary = *found,
                  .distance_m = view.distance_m(self, *found),
                  .bearing_rad = view.space.bearing_rad(view.poses[self], view.poses[*found])};
}

}  // namespace trophic::perception
