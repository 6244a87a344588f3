// SPDX-License-Identifier: MIT
// Assigns hinges to a robot's left and right side.
#pragma once

#include <cmath>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// The side of a robot's axis of symmetry that a hinge is on.
enum class Side { left, right, middle };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(Side) {
  return {"left", "right", "middle"};
}

/// Left if the cross product forward x grid position is positive, right if it is negative, middle on the axis. The spider's
/// axis lies at 45 degrees through its core, so x - y < 0 is left and x - y > 0 right.
[[nodiscard]] inline Side side_of(const Hinge& hinge, double forward_rad) {
  const double x = hinge.grid_position.x();
  const double y = hinge.grid_position.y();
  const double cross = std::cos(forward_rad) * y - std::sin(forward_rad) * x;
  if (std::abs(cross) < 1e-9) return Side::middle;
  return cross > 0.0 ? Side::left : Side::right;
}

/// The side of each hinge of a robot, in the model's order.
[[nodiscard]] inline std::vector<Side> sides_of(const RobotModel& robot) {
  std::vector<Side> sides;
  for (const Hinge& hinge : robot.hinges) sides.push_back(side_of(hinge, robot.forward_rad));
  return sides;
}

}  // namespace trophic
