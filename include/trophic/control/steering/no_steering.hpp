// SPDX-License-Identifier: MIT
// Brains have no effect on the motion of robots.
#pragma once

#include <string_view>
#include <trophic/control/steering/contract.hpp>

namespace trophic::control::steering {

/// Rule: joint targets are those of the gait, for any target angle. This is the control in which brains only choose tags. It is
/// an error on a backend without joints, which turns robots itself.   Reads: nothing.   Random draws: 0.
struct NoSteering {
  static constexpr std::string_view name = "no_steering";
  static constexpr std::string_view source = "control";
  static constexpr bool steers = false;
  void steer(double, std::span<const HingePlace>, std::span<double>) const {}
};
static_assert(Steering<NoSteering>);

}  // namespace trophic::control::steering
