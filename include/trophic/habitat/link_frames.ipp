// SPDX-License-Identifier: MIT
// Definitions of link_frames.hpp.
#pragma once

#include <trophic/habitat/link_frames.hpp>

namespace trophic {

TROPHIC_INLINE std::vector<Eigen::Isometry3d> link_frames(const RobotModel& robot, const Pose& root,
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
