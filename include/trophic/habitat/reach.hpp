// SPDX-License-Identifier: MIT
// The maximum distance of a robot's boxes from its root.
#pragma once

#include <algorithm>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// The eight corners of a box in its link's frame.
[[nodiscard]] inline std::array<Eigen::Vector3d, 8> corners(const Box& box) {
  std::array<Eigen::Vector3d, 8> result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Eigen::Vector3d sign{i & 1U ? 1.0 : -1.0, i & 2U ? 1.0 : -1.0, i & 4U ? 1.0 : -1.0};
    result.at(i) = box.centre_m + box.orientation * sign.cwiseProduct(box.half_extents_m);
  }
  return result;
}

/// An upper bound in metres for the distance of any box point from the root frame's origin, at any joint angles: the sum of the
/// outstretched lengths from link to link. Parents must come before their children.
[[nodiscard]] inline double reach_m(const RobotModel& robot) {
  std::vector<double> reach_m(robot.links.size(), 0.0);  // farthest box point beyond the link's anchor
  for (std::size_t i = robot.links.size(); i-- > 0;) {
    const Link& link = robot.links[i];
    for (const Box& box : link.boxes) {
      for (const Eigen::Vector3d& corner : corners(box)) reach_m[i] = std::max(reach_m[i], corner.norm());
    }
    if (i == 0) break;
    double& above_m = reach_m[static_cast<std::size_t>(link.parent)];
    above_m = std::max(above_m, link.offset_m.norm() + reach_m[i]);
  }
  return reach_m.empty() ? 0.0 : reach_m[0];
}

}  // namespace trophic
