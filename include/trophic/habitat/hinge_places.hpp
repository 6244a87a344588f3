// SPDX-License-Identifier: MIT
// The places of a robot's hinges, for rules that steer.
#pragma once

#include <cmath>
#include <trophic/habitat/link_frames.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// The side of a robot's axis of symmetry on which a hinge is.
enum class Side { left, right, middle };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(Side) {
  return {"left", "right", "middle"};
}

/// Left if the cross product forward x grid position is positive, right if it is negative, middle on the axis. The spider's
/// axis lies at 45 degrees through its core, so x - y < 0 is left and x - y > 0 right.
[[nodiscard]] Side side_of(const Hinge& hinge, double forward_rad);

/// A hinge from the point of view of steering rules, on a robot that stands with all joint angles 0.
struct HingePlace {
  Side side = Side::middle;
  double ahead = 0.0;    ///< position ahead of the core along the forward axis, in cells of the module grid; negative behind
  double upright = 0.0;  ///< upward component of the hinge's axis, in [-1, 1]: 0 lifts, +-1 sweeps
  friend bool operator==(const HingePlace&, const HingePlace&) = default;
};

/// The place of each hinge of a robot, in the model's order.
[[nodiscard]] std::vector<HingePlace> hinge_places(const RobotModel& robot);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/hinge_places.ipp>
#endif
