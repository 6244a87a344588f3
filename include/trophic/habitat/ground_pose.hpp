// SPDX-License-Identifier: MIT
// Projects a body's pose in space to its position and heading on the floor.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <trophic/habitat/pose.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

/// Position on the floor and heading of a robot whose forward axis lies at `forward_rad` in its root frame: the direction of that
/// axis projected on the floor (0 for an axis that points straight up or down).
[[nodiscard]] inline GroundPose ground_pose(const Pose& root, double forward_rad) {
  const Eigen::Vector3d forward = root.orientation * Eigen::Vector3d{std::cos(forward_rad), std::sin(forward_rad), 0.0};
  return {.x_m = root.position_m.x(), .y_m = root.position_m.y(), .heading_rad = std::atan2(forward.y(), forward.x())};
}

}  // namespace trophic
