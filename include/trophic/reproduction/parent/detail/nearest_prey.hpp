// SPDX-License-Identifier: MIT
// The closest prey of a dying predator; two parent rules share this.
#pragma once

#include <trophic/population/view.hpp>

namespace trophic::reproduction::parent::detail {

/// Returns the closest individual within `range_m` that the occupant of `body` could eat, if any. `only_active`: inactive
/// newborns are excluded.
[[nodiscard]] inline std::optional<Ancestor> nearest_prey(BodyIndex body, double range_m, bool only_active, const View& view) {
  const Species dying = view.robots[body].species;
  const auto eats = [&](Species other) { return view.web.eats(dying, other); };
  const auto accepts = [&](const Individual& other) { return eats(other.species) && (other.active || !only_active); };
  const auto closest = view.closest(body, accepts, {.within_m = range_m, .among = view.marks(eats, {}, only_active)});
  return closest ? std::optional{view.robots[*closest].as_ancestor()} : std::nullopt;
}

}  // namespace trophic::reproduction::parent::detail
