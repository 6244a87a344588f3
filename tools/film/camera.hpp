// SPDX-License-Identifier: MIT
// The camera of a picture, and where it sees a point.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic::film {

/// Vertical field of view, degrees.
inline constexpr double fovy_deg = 38.0;

/// Looks at a point from a distance; azimuth 90 degrees looks along +y, elevation -90 straight down.
struct Camera {
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();
  double distance_m = 10.0;
  double azimuth_deg = 90.0;
  double elevation_deg = -50.0;
};

/// A place in a picture: x and y are 0 in its middle; y is 1 at its upper and -1 at its lower edge, x as long as y.
struct PicturePoint {
  double x = 0.0;
  double y = 0.0;
};

/// A camera as three axes and a place.
struct Sight {
  Eigen::Vector3d eye_m;
  Eigen::Vector3d forward;
  Eigen::Vector3d right;
  Eigen::Vector3d up;

  explicit Sight(const Camera& camera) {
    const double azimuth = camera.azimuth_deg * std::numbers::pi / 180.0;
    const double elevation = camera.elevation_deg * std::numbers::pi / 180.0;
    forward = {std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation), std::sin(elevation)};
    right = {std::sin(azimuth), -std::cos(azimuth), 0.0};
    up = right.cross(forward);
    eye_m = camera.at_m - camera.distance_m * forward;
  }
};

/// Half of the visible height at a distance of 1.
[[nodiscard]] inline double half_height() {
  return std::tan(0.5 * fovy_deg * std::numbers::pi / 180.0);
}

/// Returns the place of a point in the picture; `nullopt` behind the camera.
[[nodiscard]] inline std::optional<PicturePoint> seen_at(const Camera& camera, const Eigen::Vector3d& point_m) {
  const Sight sight{camera};
  const Eigen::Vector3d way = point_m - sight.eye_m;
  const double depth = way.dot(sight.forward) * half_height();
  if (!(depth > 0.0)) return std::nullopt;
  return PicturePoint{way.dot(sight.right) / depth, way.dot(sight.up) / depth};
}

/// Sees the whole arena from the south, as near as all of its corners are in the picture. `aspect`: width over height of the
/// picture.
[[nodiscard]] inline Camera whole_arena(const Arena& arena, double aspect) {
  const double half = arena.half_side_m;
  Camera camera{.at_m = Eigen::Vector3d::Zero(), .distance_m = 2.2 * half, .azimuth_deg = 90.0, .elevation_deg = -50.0};
  const auto corner = [&](double x, double y) { return *seen_at(camera, {1.05 * half * x, 1.05 * half * y, 0.0}); };
  for (int i = 0; i < 60; ++i) {
    const double low = corner(1, -1).y;
    const double high = corner(1, 1).y;
    camera.at_m.y() += 0.25 * (low + high) * half;
    const double needed = std::max(corner(1, -1).x / aspect / 0.96, (high - low) / 1.88);
    camera.distance_m *= 1.0 + 0.7 * (needed - 1.0);
  }
  return camera;
}

/// Sees the whole arena from above, north at the top.
[[nodiscard]] inline Camera from_above(const Arena& arena, double aspect) {
  return {.at_m = Eigen::Vector3d::Zero(),
          .distance_m = 3.1 * std::max(1.0, 1.05 / aspect) * arena.half_side_m,
          .azimuth_deg = 90.0,
          .elevation_deg = -90.0};
}

/// Looks at a robot from near.
[[nodiscard]] inline Camera near(const RobotModel& robot, const Eigen::Vector3d& at_m) {
  return {.at_m = {at_m.x(), at_m.y(), 0.0},
          .distance_m = 13.0 * robot.bounding_radius_m,
          .azimuth_deg = 90.0,
          .elevation_deg = -33.0};
}

/// The edge of what a picture shows of an arena.
struct Edge {
  double at_m = 0.0;      ///< from the middle
  double height_m = 0.0;  ///< how high walls or slopes rise there
};

/// The slopes of an arena rise too high for a picture and are drawn at most so high, as in the browser.
inline constexpr double highest_slope_m = 1.5;

[[nodiscard]] inline Edge edge_of(const Arena& arena) {
  if (!arena.height_field) return {arena.half_side_m, 0.035 * arena.half_side_m};
  return {arena.height_field->half_extent_m, std::min(highest_slope_m, std::ranges::max(arena.height_field->height_m))};
}

}  // namespace trophic::film
