// SPDX-License-Identifier: MIT
// The pose of a rigid body.
#pragma once

#include <Eigen/Geometry>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// The pose of a rigid body: the world position of its frame and the rotation from its frame to the world.
struct Pose {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

}  // namespace trophic
