// SPDX-License-Identifier: MIT
// Converts places on the floor to initial poses of robots.
#pragma once

#include <span>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// Root frames of robots that stand at these places: upright, feet on the highest ground below.
[[nodiscard]] std::vector<Pose> standing_poses(std::span<const GroundPose> places, const RobotModel& robot, const Arena& arena);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/ecology/standing_poses.ipp>
#endif
