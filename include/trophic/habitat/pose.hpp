// SPDX-License-Identifier: MIT
// Where a rigid body is in space.
#pragma once

#include <Eigen/Geometry>

namespace trophic {

/// Where a rigid body is: the world position of its frame and the rotation from its frame to the world.
struct Pose {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

}  // namespace trophic
