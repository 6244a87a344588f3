// SPDX-License-Identifier: MIT
// The place of a camera that stands still for a scene.
#pragma once

#include <span>
#include <tools/film/camera.hpp>
#include <vector>

namespace trophic::command::replay {

/// The path of a robot that stays in the picture.
struct Track {
  std::vector<Eigen::Vector3d> places_m;
  double radius_m = 0.0;  ///< of its body
};

/// A direction and a point to look at, for pictures of any shape.
struct Shot {
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();
  double azimuth_deg = 90.0;
  double elevation_deg = -50.0;
  double near_m = 0.0;         ///< how far the nearest robot comes from that point towards the camera
  double high_m = 1.0;         ///< the distance from that robot at which all paths fit between the texts above and below
  double wide_m = 1.0;         ///< and at which they fit into the width of a square picture
  bool is_inside = true;       ///< whether the camera stands inside the arena: no wall is in front of the scene
  double outside_share = 0.0;  ///< of the picture: neither floor nor walls nor slopes

  /// `aspect`: width over height of the picture.
  [[nodiscard]] film::Camera camera(double aspect) const {
    return {.at_m = at_m,
            .distance_m = near_m + std::max(high_m, wide_m / aspect),
            .azimuth_deg = azimuth_deg,
            .elevation_deg = elevation_deg};
  }
};

/// Shape of the picture that a shot is chosen for; wider pictures are taken from no farther away.
inline constexpr double aspect_of_shots = 4.0 / 3.0;

/// Returns the shot of these robots, at least one with a place. It stands inside the arena if any does; then it is the one that
/// has the least of the picture outside, the robots large, and a low camera.
[[nodiscard]] Shot shot_of(std::span<const Track> tracks, const Arena& arena);

}  // namespace trophic::command::replay
