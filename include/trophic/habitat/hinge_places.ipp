// SPDX-License-Identifier: MIT
// Definitions of hinge_places.hpp.
#pragma once

#include <cmath>
#include <trophic/habitat/hinge_places.hpp>
#include <trophic/habitat/link_frames.hpp>

namespace trophic {

TROPHIC_INLINE Side side_of(const Hinge& hinge, double forward_rad) {
  const double x = hinge.grid_position.x();
  const double y = hinge.grid_position.y();
  const double cross = std::cos(forward_rad) * y - std::sin(forward_rad) * x;
  if (std::abs(cross) < 1e-9) return Side::middle;
  return cross > 0.0 ? Side::left : Side::right;
}

TROPHIC_INLINE std::vector<HingePlace> hinge_places(const RobotModel& robot) {
  std::vector<HingePlace> places;
  const std::vector<Eigen::Isometry3d> frames = link_frames(robot, Pose{}, {});
  for (std::size_t i = 0; i < robot.hinges.size(); ++i) {
    const Hinge& hinge = robot.hinges[i];
    const Eigen::Vector3d axis = frames[i + 1].linear() * hinge.axis;
    const double ahead =
        std::cos(robot.forward_rad) * hinge.grid_position.x() + std::sin(robot.forward_rad) * hinge.grid_position.y();
    places.push_back({.side = side_of(hinge, robot.forward_rad), .ahead = ahead, .upright = axis.z()});
  }
  return places;
}

}  // namespace trophic
