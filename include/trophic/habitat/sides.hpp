// SPDX-License-Identifier: MIT
// Assigns hinges to a robot's left and right side.
#pragma once

#include <array>
#include <string_view>
#include <trophic/support/linkage.hpp>
#include <vector>

namespace trophic {

struct Hinge;
struct RobotModel;

/// The side of a robot's axis of symmetry that a hinge is on.
enum class Side { left, right, middle };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(Side) {
  return {"left", "right", "middle"};
}

/// Left if the cross product forward x grid position is positive, right if it is negative, middle on the axis. The spider's
/// axis lies at 45 degrees through its core, so x - y < 0 is left and x - y > 0 right.
[[nodiscard]] Side side_of(const Hinge& hinge, double forward_rad);

/// The side of each hinge of a robot, in the model's order.
[[nodiscard]] std::vector<Side> sides_of(const RobotModel& robot);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/sides.ipp>
#endif
