// SPDX-License-Identifier: MIT
// The released code's heading: the yaw of the root frame plus a constant.
#pragma once

#include <string_view>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/perception/heading/contract.hpp>
#include <trophic/support/units.hpp>

namespace trophic::perception::heading {

/// Rule (released code): heading = yaw + forward_rad, where yaw is the direction of the root frame's x axis projected on the
/// floor. The spider's forward axis lies 45 degrees from x. For an upright spider this is where that axis points; on its back its
/// heading is 90 degrees off, and it perceives some adversaries on the wrong side.   Reads: root pose.   Random draws: 0.
struct RootYawHeading {
  static constexpr std::string_view name = "root_yaw_heading";
  static constexpr std::string_view source = "released code";
  static constexpr bool acts_on_tilt_alone = true;
  [[nodiscard]] double heading_rad(const Pose& root, double forward_rad) const {
    return wrap_angle(ground_pose(root, 0.0).heading_rad + forward_rad);
  }
};
static_assert(Heading<RootYawHeading>);

}  // namespace trophic::perception::heading
