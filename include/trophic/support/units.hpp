// SPDX-License-Identifier: MIT
// Units and frames of the whole library, and the geometric types that every part shares.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <trophic/support/cpp20.hpp>
#include <tuple>

namespace trophic {

/// Units: SI and radians. Frames: right-handed, z up. Quaternions: w, x, y, z when written as four numbers.
/// A name ends in its unit (`range_m`, `age_s`, `target_angle_rad`); a name without one has no dimension.
/// Time is simulated time. `time_s` in rules and logs is the ecology's clock, which runs `EcologyParams::clock_scale` times
/// slower than the physics (1 in the paper's rules).

/// Position and heading of a robot on the floor, the only data of a body that rules of perception, birth and death read.
struct GroundPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;  ///< counter-clockwise from world x to the robot's forward axis, in (-pi, pi]
  static constexpr auto saved() { return std::tuple{&GroundPose::x_m, &GroundPose::y_m, &GroundPose::heading_rad}; }
  friend bool operator==(const GroundPose&, const GroundPose&) = default;
};

/// Wraps an angle into (-pi, pi] by whole turns.
[[nodiscard]] inline double wrap_angle(double angle_rad) {
  const bool is_wrapped = std::abs(angle_rad) < std::numbers::pi;  // then the remainder, which is slow, is the angle
  const double wrapped = is_wrapped ? angle_rad : std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

/// The topology of the floor, for distances: bounded by walls, or a torus, on which the shortest path may cross an edge.
struct Space {
  double period_m = 0.0;  ///< the side of the torus; 0: none

  [[nodiscard]] bool has_edges() const { return period_m <= 0.0; }
  /// An offset along one side, across the edge if that is shorter; for a position, the equivalent position in the square.
  [[nodiscard]] double shortest(double offset_m) const { return has_edges() ? offset_m : std::remainder(offset_m, period_m); }
  /// The offset from one position to another along x and y.
  [[nodiscard]] std::array<double, 2> way_m(const GroundPose& from, const GroundPose& to) const {
    return {shortest(to.x_m - from.x_m), shortest(to.y_m - from.y_m)};
  }
  [[nodiscard]] double distance_m(const GroundPose& a, const GroundPose& b) const {
    const auto [dx, dy] = way_m(a, b);
    return std::sqrt(dx * dx + dy * dy);
  }
  /// Direction of `target` seen from `self`, relative to its heading: 0 ahead, positive to the right (the sense of the paper's
  /// target angle alpha), in [-pi, pi).
  [[nodiscard]] double bearing_rad(const GroundPose& self, const GroundPose& target) const {
    const auto [dx, dy] = way_m(self, target);
    return -wrap_angle(std::atan2(dy, dx) - self.heading_rad);
  }
  /// Calls `visit` with a position and, on a torus, with its eight images next to the square.
  template <class Visit>
  void for_each_image(const GroundPose& place, Visit&& visit) const {
    for (int image = 0; image < (has_edges() ? 1 : 9); ++image) {  // 0: the place itself
      visit(GroundPose{place.x_m + ((image + 1) % 3 - 1) * period_m, place.y_m + ((image / 3 + 1) % 3 - 1) * period_m});
    }
  }
};

/// Both between walls.
[[nodiscard]] inline double distance_m(const GroundPose& a, const GroundPose& b) {
  return Space{}.distance_m(a, b);
}
[[nodiscard]] inline double bearing_rad(const GroundPose& self, const GroundPose& target) {
  return Space{}.bearing_rad(self, target);
}

}  // namespace trophic
