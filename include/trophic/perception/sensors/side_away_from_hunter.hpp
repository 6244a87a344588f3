// SPDX-License-Identifier: MIT
// The released code's Angle input: the hunted see the side that leads away.
#pragma once

#include <string_view>
#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: as SideOfAdversary, but turned by pi for an individual whose adversary eats it: +1 means predator on the left for
/// prey, prey on the right for predators (released code).   Reads: bearing, both species.   Random draws: 0.
struct SideAwayFromHunter {
  static constexpr std::string_view name = "side_away_from_hunter";
  static constexpr std::string_view source = "released code";
  [[nodiscard]] double input(const Sighting& sighting, const View& view) const {
    const double side = sighting.bearing_rad < 0.0 ? -1.0 : 1.0;
    const bool hunted = view.web.eats(view.robots[sighting.adversary].species, view.robots[sighting.self].species);
    return hunted ? -side : side;
  }
};
static_assert(SightingInput<SideAwayFromHunter>);

}  // namespace trophic::perception::sensors
