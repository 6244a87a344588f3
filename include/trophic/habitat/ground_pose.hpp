// SPDX-License-Identifier: MIT
// Projects a body's pose in space to its position and heading on the floor.
#pragma once

#include <trophic/support/linkage.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

struct Pose;

/// Position on the floor and heading of a robot whose forward axis lies at `forward_rad` in its root frame: the direction of that
/// axis projected on the floor (0 for an axis that points straight up or down).
[[nodiscard]] GroundPose ground_pose(const Pose& root, double forward_rad);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/ground_pose.ipp>
#endif
