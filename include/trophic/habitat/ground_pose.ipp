// SPDX-License-Identifier: MIT
// Definitions of ground_pose.hpp.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/habitat/pose.hpp>

namespace trophic {

TROPHIC_INLINE GroundPose ground_pose(const Pose& root, double forward_rad) {
  const Eigen::Vector3d forward = root.orientation * Eigen::Vector3d{std::cos(forward_rad), std::sin(forward_rad), 0.0};
  return {.x_m = root.position_m.x(), .y_m = root.position_m.y(), .heading_rad = std::atan2(forward.y(), forward.x())};
}

}  // namespace trophic
