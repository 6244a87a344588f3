// SPDX-License-Identifier: MIT
// Circular zones that are part of the resource field.
#pragma once

#include <optional>
#include <trophic/population/view.hpp>

namespace trophic {

/// A circle on the floor around the centre of a cell.
struct MatingZone {
  std::size_t cell = 0;
  GroundPose centre = {};
  double radius_m = 0.0;
};

/// The layer of a field that holds, in the cell of each zone's centre, the radius of the zone, and 0 elsewhere.
inline constexpr std::size_t zone_layer = 0;

/// The zones of a field in the order of their cells; none without a field or without that layer.
[[nodiscard]] inline std::vector<MatingZone> zones_in(const ResourceField* field) {
  std::vector<MatingZone> zones;
  if (field == nullptr || field->layers() <= zone_layer) return zones;
  for (std::size_t cell = 0; cell < field->cells(); ++cell)
    if (const double radius_m = field->layer(zone_layer, cell); radius_m > 0.0)
      zones.push_back({cell, field->centre(cell), radius_m});
  return zones;
}

[[nodiscard]] inline std::vector<MatingZone> zones_in(const View& view) {
  return zones_in(view.field);
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
