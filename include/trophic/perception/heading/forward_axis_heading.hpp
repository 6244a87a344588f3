// SPDX-License-Identifier: MIT
// The heading along the robot's forward axis.
#pragma once

#include <string_view>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/perception/heading/contract.hpp>

namespace trophic::perception::heading {

/// Rule: the heading is the direction of the robot's forward axis projected on the floor. The paper has only "a predefined
/// frame of reference that establishes the front orientation" (Sec. "Targeted Steering"); here the front is a part of the body,
/// so it stays the front of a robot on its back. The released code uses RootYawHeading.   Reads: root pose.   Random draws: 0.
struct ForwardAxisHeading {
  static constexpr std::string_view name = "forward_axis_heading";
  static constexpr std::string_view source = "paper, Sec. \"Targeted Steering\"; silent on tilted bodies";
  static constexpr bool acts_on_tilt_alone = true;
  [[nodiscard]] double heading_rad(const Pose& root, double forward_rad) const {
    return ground_pose(root, forward_rad).heading_rad;
  }
};
static_assert(Heading<ForwardAxisHeading>);

}  // namespace trophic::perception::heading
