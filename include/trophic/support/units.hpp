// SPDX-License-Identifier: MIT
// Units and frames of the whole library, and the geometric types that every part shares.
#pragma once

#include <cmath>
#include <numbers>
#include <trophic/support/cpp20.hpp>
#include <tuple>

namespace trophic {

/// Units: SI and radians. Frames: right-handed, z up. Quaternions: w, x, y, z when written as four numbers.
/// A name ends in its unit (`range_m`, `age_s`, `target_angle_rad`); a name without one has no dimension.
/// Time is simulated time. `time_s` in rules and logs is the ecology's clock, which runs `EcologyParams::clock_scale` times
/// slower than the physics (1 in the paper's rules).

/// Position and heading of a robot on the floor; all that perception, birth and death rules read of a body.
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

/// An offset on a torus of side `period_m`, over its edge if that is shorter; the same in an arena with walls, `period_m` 0.
[[nodiscard]] inline double shortest(double offset_m, double period_m) {
  return period_m > 0.0 ? std::remainder(offset_m, period_m) : offset_m;
}

/// Horizontal distance between two robots, m.
[[nodiscard]] inline double distance_m(const GroundPose& a, const GroundPose& b, double period_m = 0.0) {
  const double dx = shortest(b.x_m - a.x_m, period_m);
  const double dy = shortest(b.y_m - a.y_m, period_m);
  return std::sqrt(dx * dx + dy * dy);
}

/// Direction of `target` seen from `self`, relative to its heading: 0 ahead, positive to the right (the sense of the paper's
/// target angle alpha), in [-pi, pi).
[[nodiscard]] inline double bearing_rad(const GroundPose& self, const GroundPose& target, double period_m = 0.0) {
  const double direction_rad = std::atan2(shortest(target.y_m - self.y_m, period_m), shortest(target.x_m - self.x_m, period_m));
  return -wrap_angle(direction_rad - self.heading_rad);
}

}  // namespace trophic
