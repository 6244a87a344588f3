// SPDX-License-Identifier: MIT
// Definitions of sides.hpp.
#pragma once

#include <cmath>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/habitat/sides.hpp>

namespace trophic {

TROPHIC_INLINE Side side_of(const Hinge& hinge, double forward_rad) {
  const double x = hinge.grid_position.x();
  const double y = hinge.grid_position.y();
  const double cross = std::cos(forward_rad) * y - std::sin(forward_rad) * x;
  if (std::abs(cross) < 1e-9) return Side::middle;
  return cross > 0.0 ? Side::left : Side::right;
}

TROPHIC_INLINE std::vector<Side> sides_of(const RobotModel& robot) {
  std::vector<Side> sides;
  for (const Hinge& hinge : robot.hinges) sides.push_back(side_of(hinge, robot.forward_rad));
  return sides;
}

}  // namespace trophic
