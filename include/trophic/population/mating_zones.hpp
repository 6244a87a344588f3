// SPDX-License-Identifier: MIT
// Circular zones that are part of the resource field.
#pragma once

#include <algorithm>
#include <optional>
#include <trophic/population/view.hpp>

namespace trophic {

/// A circle on the floor around the centre of a cell.
struct MatingZone {
  std::size_t cell = 0;
  GroundPose centre = {};
  double radius_m = 0.0;
};

/// The zones of a field in the order of their cells.
[[nodiscard]] inline std::vector<MatingZone> zones_in(const ResourceField& field) {
  std::vector<MatingZone> zones;
  for (std::size_t cell = 0; field.has_zones() && cell < field.cells(); ++cell)
    if (const double radius_m = field.zone_m(cell); radius_m > 0.0) zones.push_back({cell, field.centre(cell), radius_m});
  return zones;
}

/// The zones of the first field that has any.
[[nodiscard]] inline std::vector<MatingZone> zones_in(const View& view) {
  const auto field = std::ranges::find_if(view.foods, &ResourceField::has_zones);
  return field == view.foods.end() ? std::vector<MatingZone>{} : zones_in(*field);
}

/// Whether a position is in a zone, across the edges on a torus.
[[nodiscard]] inline bool is_in(const MatingZone& zone, const GroundPose& at, const View& view) {
  return view.distance_m(zone.centre, at) <= zone.radius_m;
}

/// The zone whose centre is nearest to a position; empty if there is none.
[[nodiscard]] inline std::optional<MatingZone> nearest_zone(const GroundPose& at, const View& view) {
  std::optional<MatingZone> nearest;
  double nearest_m = 0.0;
  for (const MatingZone& zone : zones_in(view)) {
    const double away_m = view.distance_m(zone.centre, at);
    if (nearest && away_m >= nearest_m) continue;
    nearest = zone;
    nearest_m = away_m;
  }
  return nearest;
}

}  // namespace trophic
