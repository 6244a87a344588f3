// SPDX-License-Identifier: MIT
// The pose of a rigid body.
#pragma once

#include <Eigen/Geometry>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// The pose of a rigid body: the world position of its frame and the rotation from its frame to the world.
struct Pose {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};
static_assert(TROPHIC_HEADER_ONLY ? EIGEN_MAX_ALIGN_BYTES <= 16 || !EIGEN_MALLOC_ALREADY_ALIGNED : alignof(Pose) == 16,
              "trophic's libraries have -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MALLOC_ALREADY_ALIGNED=1 and no other Eigen option");

}  // namespace trophic
