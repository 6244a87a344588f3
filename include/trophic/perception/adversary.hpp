// SPDX-License-Identifier: MIT
// The closest perceivable opponent.
#pragma once

#include <optional>
#include <trophic/population/view.hpp>
#include <trophic/support/units.hpp>

namespace trophic::perception {

/// An individual's adversary: the closest opponent that it perceives (Sec. "Inputs").
struct Sighting {
  BodyIndex self = 0;
  BodyIndex adversary = 0;
  double distance_m = 0.0;
  double bearing_rad = 0.0;  ///< 0 ahead, positive to the right, in [-pi, pi)
};

/// The adversary of `self`: "the closest observable robot of the opposite species" (Sec. "Inputs"); with more than two
/// species, of any species that eats its own or that its own eats. On equal distance the lower body
/// index.   Random draws: 0.
[[nodiscard]] inline std::optional<Sighting> adversary(BodyIndex self, const View& view) {
  const Individual& observer = view.robots[self];
  const auto found = view.closest(self, [&](const Individual& other) {
    return view.web.opponents(observer.species, other.species) && view.perceives(observer, other);
  });
  if (!found) return std::nullopt;
  return Sighting{.self = self,
                  .adversary = *found,
                  .distance_m = view.distance_m(self, *found),
                  .bearing_rad = bearing_rad(view.poses[self], view.poses[*found])};
}

}  // namespace trophic::perception
