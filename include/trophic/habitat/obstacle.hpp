// SPDX-License-Identifier: MIT
// Things that stand on the floor: pillars and inner walls.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <trophic/params/params.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

/// All points of the floor at most `radius_m` from the segment between two points, up to a height. For a pillar both points are
/// equal; otherwise it is a wall with round ends.
struct Obstacle {
  double x_m = 0.0;
  double y_m = 0.0;
  double to_x_m = 0.0;
  double to_y_m = 0.0;
  double radius_m = 0.1;  ///< half of a wall's thickness
  double height_m = 0.5;

  [[nodiscard]] bool is_pillar() const { return x_m == to_x_m && y_m == to_y_m; }
  [[nodiscard]] double length_m() const { return std::sqrt((to_x_m - x_m) * (to_x_m - x_m) + (to_y_m - y_m) * (to_y_m - y_m)); }

  [[nodiscard]] double middle_x_m() const { return 0.5 * (x_m + to_x_m); }
  [[nodiscard]] double middle_y_m() const { return 0.5 * (y_m + to_y_m); }
  /// The angle counter-clockwise from world x to a wall's length.
  [[nodiscard]] double turn_rad() const { return std::atan2(to_y_m - y_m, to_x_m - x_m); }

  static constexpr auto fields() {
    return std::tuple{field("x_m", &Obstacle::x_m),
                      field("y_m", &Obstacle::y_m),
                      field("to_x_m", &Obstacle::to_x_m),
                      field("to_y_m", &Obstacle::to_y_m),
                      field("radius_m", &Obstacle::radius_m, above_to(0.0, 1e3)),
                      field("height_m", &Obstacle::height_m, above_to(0.0, 1e3))};
  }
  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

/// The point of an obstacle's segment closest to a point.
[[nodiscard]] inline std::array<double, 2> closest_on_axis(const Obstacle& obstacle, double x_m, double y_m) {
  const double along_x_m = obstacle.to_x_m - obstacle.x_m;
  const double along_y_m = obstacle.to_y_m - obstacle.y_m;
  const double length2 = along_x_m * along_x_m + along_y_m * along_y_m;
  const double dot = (x_m - obstacle.x_m) * along_x_m + (y_m - obstacle.y_m) * along_y_m;
  const double part = length2 > 0.0 ? std::clamp(dot / length2, 0.0, 1.0) : 0.0;
  return {obstacle.x_m + part * along_x_m, obstacle.y_m + part * along_y_m};
}

/// The distance from a point to an obstacle's surface on the floor; negative inside.
[[nodiscard]] inline double distance_m(const Obstacle& obstacle, double x_m, double y_m) {
  const auto [axis_x_m, axis_y_m] = closest_on_axis(obstacle, x_m, y_m);
  return std::sqrt((x_m - axis_x_m) * (x_m - axis_x_m) + (y_m - axis_y_m) * (y_m - axis_y_m)) - obstacle.radius_m;
}

namespace detail {

/// The distance along a ray to a circle, empty if it misses; 0 from inside. The direction has length 1.
[[nodiscard]] inline std::optional<double> ray_to_circle_m(double dx_m, double dy_m, double cos, double sin, double radius_m) {
  const double ahead_m = dx_m * cos + dy_m * sin;
  const double distance2 = dx_m * dx_m + dy_m * dy_m;
  if (distance2 <= radius_m * radius_m) return 0.0;
  const double half_chord2 = radius_m * radius_m - (distance2 - ahead_m * ahead_m);
  if (ahead_m < 0.0 || half_chord2 < 0.0) return std::nullopt;
  return ahead_m - std::sqrt(half_chord2);
}

}  // namespace detail

/// The distance from a point along a direction of length 1 to an obstacle; 0 from inside, empty if the ray misses it.
[[nodiscard]] inline std::optional<double> ray_m(const Obstacle& obstacle, const GroundPose& from, double cos, double sin) {
  if (distance_m(obstacle, from.x_m, from.y_m) <= 0.0) return 0.0;
  double nearest_m = std::numeric_limits<double>::infinity();
  const auto take = [&](std::optional<double> hit_m) { nearest_m = std::min(nearest_m, hit_m.value_or(nearest_m)); };
  take(detail::ray_to_circle_m(obstacle.x_m - from.x_m, obstacle.y_m - from.y_m, cos, sin, obstacle.radius_m));
  if (!obstacle.is_pillar()) {
    take(detail::ray_to_circle_m(obstacle.to_x_m - from.x_m, obstacle.to_y_m - from.y_m, cos, sin, obstacle.radius_m));
    const double length_m = obstacle.length_m();
    const double ux = (obstacle.to_x_m - obstacle.x_m) / length_m;
    const double uy = (obstacle.to_y_m - obstacle.y_m) / length_m;
    const double across = uy * cos - ux * sin;  // of the heading, to the wall's right
    const double off_m = uy * (from.x_m - obstacle.x_m) - ux * (from.y_m - obstacle.y_m);
    const double hit_m = (std::copysign(obstacle.radius_m, off_m) - off_m) / across;
    const double along_m = ux * (from.x_m + hit_m * cos - obstacle.x_m) + uy * (from.y_m + hit_m * sin - obstacle.y_m);
    if (across != 0.0 && hit_m >= 0.0 && along_m >= 0.0 && along_m <= length_m) take(hit_m);
  }
  return std::isfinite(nearest_m) ? std::optional{nearest_m} : std::nullopt;
}

}  // namespace trophic
