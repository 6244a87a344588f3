// SPDX-License-Identifier: MIT
// The frames of all links of a robot, given its root and its joint angles.
#pragma once

#include <span>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// Forward kinematics: the frame of each link in the world, in the model's order. `joint_angles_rad` has one angle a hinge, in
/// the model's order; empty: all 0.
[[nodiscard]] inline std::vector<Eigen::Isometry3d> link_frames(const RobotModel& robot, const Pose& root,
                                                                std::span<const double> joint_angles_rad) {
  std::vector<Eigen::Isometry3d> frames(robot.links.size());
  frames[0] = Eigen::Translation3d{root.position_m} * root.orientation;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const Link& link = robot.links[i];
    frames[i] = frames[static_cast<std::size_t>(link.parent)] * Eigen::Translation3d{link.offset_m} * link.rotation;
    if (!joint_angles_rad.empty()) {
      frames[i] = frames[i] * Eigen::AngleAxisd{joint_angles_rad[i - 1], robot.hinges[i - 1].axis};
    }
  }
  return frames;
}

}  // namespace trophic
