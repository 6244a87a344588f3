// SPDX-License-Identifier: MIT
// Steers a robot without sides by bending its body.
#pragma once

#include <cstddef>
#include <trophic/control/steering/contract.hpp>
#include <trophic/params/params.hpp>

namespace trophic::control::steering {

/// Rule: `bend` * alpha * u is added to the target of each hinge with an upright axis, where u is the upward part of the axis;
/// hinges ahead of the core get the opposite sign. A robot that walks forward thus bends to the side of the target angle alpha,
/// as snakes and snake robots turn by an offset of their joints [hirose2009]. Hinges that lift (|u| < 0.5) keep their targets.
/// The servos' limit applies afterwards. `bend` is a free parameter.   Reads: target angle, places of hinges.   Random draws: 0.
struct BendingSteering {
  static constexpr std::string_view name = "bending_steering";
  static constexpr std::string_view source = "not in the paper; [hirose2009]";

  struct Params {
    double bend = 0.5;
    static constexpr auto fields() {
      return std::tuple{field("bend", &Params::bend, between(0.0, 10.0), "offset of a hinge, rad per rad of target angle")};
    }
  };
  Params params;

  void steer(double target_angle_rad, std::span<const HingePlace> hinges, std::span<double> targets_rad) const {
    for (std::size_t i = 0; i < targets_rad.size(); ++i) {
      if (std::abs(hinges[i].upright) < 0.5) continue;
      targets_rad[i] += params.bend * target_angle_rad * (hinges[i].ahead > 0.0 ? -hinges[i].upright : hinges[i].upright);
    }
  }
};
static_assert(Steering<BendingSteering>);

}  // namespace trophic::control::steering
