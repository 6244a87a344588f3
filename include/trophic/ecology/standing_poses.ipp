// SPDX-License-Identifier: MIT
// Definitions of standing_poses.hpp.
#pragma once

#include <trophic/ecology/standing_poses.hpp>

namespace trophic {

TROPHIC_INLINE std::vector<Pose> standing_poses(std::span<const GroundPose> places, const RobotModel& robot, const Arena& arena) {
  std::vector<Pose> poses;
  for (const GroundPose& ground : places) {
    const double yaw_rad = ground.heading_rad - robot.forward_rad;
    poses.push_back(
        {.position_m = {ground.x_m, ground.y_m, robot.rest_height_m + highest_below_m(arena, ground, robot.bounding_radius_m)},
         .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{yaw_rad, Eigen::Vector3d::UnitZ()}}});
  }
  return poses;
}

}  // namespace trophic
