// SPDX-License-Identifier: MIT
// Targeted steering: reduces the motion of the hinges on the side of the turn.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <trophic/control/steering/contract.hpp>
#include <trophic/params/params.hpp>

namespace trophic::control::steering {

/// Rule: delta = ((pi - |alpha|) / pi)^exponent scales the targets of the hinges on one side: the right side for a target angle
/// alpha > 0 (turn right), the left side for alpha < 0 (Sec. "Targeted Steering", Eq. 1: exponent 2; alpha = +-0.7: delta =
/// 0.604). The servos' limit applies afterwards, as in the released code; the paper is silent.   Reads: target angle, sides.
/// Random draws: 0.
struct TargetedSteering {
  static constexpr std::string_view name = "targeted_steering";
  static constexpr std::string_view source = "paper, Sec. \"Targeted Steering\", Eq. 1";
  static constexpr bool walks_use_it = true;

  struct Params {
    double exponent = 2.0;
    static constexpr auto fields() {
      return std::tuple{
          field("exponent", &Params::exponent, at_least(0.0), "exponent of delta = ((pi - |alpha|) / pi)^exponent")};
    }
  };
  Params params;

  /// Returns delta for a target angle: 1 at 0, and 0 at +-pi and beyond.
  [[nodiscard]] double slowing(double target_angle_rad) const {
    const double left_over = std::max(0.0, std::numbers::pi - std::abs(target_angle_rad));
    return std::pow(left_over / std::numbers::pi, params.exponent);
  }

  void steer(double target_angle_rad, std::span<const HingePlace> hinges, std::span<double> targets_rad) const {
    if (target_angle_rad == 0.0) return;
    const Side slow = target_angle_rad > 0.0 ? Side::right : Side::left;
    const double delta = slowing(target_angle_rad);
    for (std::size_t i = 0; i < targets_rad.size(); ++i) {
      if (hinges[i].side == slow) targets_rad[i] *= delta;
    }
  }
};
static_assert(Steering<TargetedSteering>);

}  // namespace trophic::control::steering
