// SPDX-License-Identifier: MIT
// The direction and the distance of the nearest zone.
#pragma once

#include <trophic/perception/sensors/contract.hpp>
#include <trophic/population/mating_zones.hpp>

namespace trophic::perception::sensors {

/// Rule: three values, the unit vector to the centre of the nearest zone, ahead and to the right, and the distance to it over the
/// arena's half side, at most 1; 0, 0 and 1 without a zone. [peterson2026] has the direction to an assigned zone.
/// Reads: own pose, zones.   Random draws: 0.
struct NearestZone {
  static constexpr std::string_view name = "nearest_zone";
  static constexpr std::string_view source = "not in the paper; direction as in [peterson2026]";
  static constexpr std::size_t size = 3;
  static constexpr double least = -1.0;
  static constexpr double most = 1.0;

  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    const auto zone = nearest_zone(view.poses[self], view);
    if (!zone) return {0.0, 0.0, 1.0};
    const double bearing_rad = view.space.bearing_rad(view.poses[self], zone->centre);
    const double far = view.distance_m(view.poses[self], zone->centre) / view.arena.half_side_m;
    return {std::cos(bearing_rad), std::sin(bearing_rad), std::min(far, 1.0)};
  }
};
static_assert(OwnSensor<NearestZone>);

}  // namespace trophic::perception::sensors
