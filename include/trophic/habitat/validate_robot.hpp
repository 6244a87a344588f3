// SPDX-License-Identifier: MIT
// The invariants of a RobotModel.
#pragma once

#include <trophic/support/linkage.hpp>

namespace trophic {

struct RobotModel;

/// Throws std::invalid_argument "robot NAME: FIELD = VALUE: must be ..." for the first broken invariant: sizes that agree, unique
/// names, parents before children, finite geometry, unit axes and rotations, masses > 0, box masses that sum to the link's mass,
/// inertias that a rigid body can have (positive definite, no principal moment above the sum of the other two), servo gains >= 0,
/// ranges and limits > 0, neighbours ascending and mutual, friction >= 0, walk within its bounds, rest height and bounding radius
/// > 0, no box beyond that radius at any angles (trophic/habitat/reach.hpp).
void validate(const RobotModel& robot);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/validate_robot.ipp>
#endif
