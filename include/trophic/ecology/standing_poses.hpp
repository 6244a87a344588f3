// SPDX-License-Identifier: MIT
// Converts places on the floor to initial poses of robots.
#pragma once

#include <span>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

/// Root frames of robots that stand at these places: upright, feet on the highest ground below.
[[nodiscard]] inline std::vector<Pose> standing_poses(std::span<const GroundPose> places, const RobotModel& robot,
                                                      const Arena& arena) {
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
