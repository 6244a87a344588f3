// SPDX-License-Identifier: MIT
// The released code's Angle input: for hunted species, the side away from the predator.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: like SideOfAdversary, but turned by pi for an individual whose adversary eats it: +1 means predator on the left for
/// prey, prey on the right for predators (released code). 0 without an adversary.   Reads: bearing, both species.   Random draws:
/// 0.
struct SideAwayFromHunter {
  static constexpr std::string_view name = "side_away_from_hunter";
  static constexpr std::string_view source = "released code";
  static constexpr std::size_t size = 1;
  static constexpr double least = -1.0;
  static constexpr double most = 1.0;
  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>& sighting, const View& view,
                                               Rng&) const {
    if (!sighting) return {0.0};
    const double side = sighting->bearing_rad < 0.0 ? -1.0 : 1.0;
    const bool hunted = view.web.eats(view.robots[sighting->adversary].species, view.robots[self].species);
    return {hunted ? -side : side};
  }
};
static_assert(OwnSensor<SideAwayFromHunter>);

}  // namespace trophic::perception::sensors
