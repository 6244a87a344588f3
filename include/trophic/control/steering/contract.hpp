// SPDX-License-Identifier: MIT
// The contract of a slot: the effect of a target angle on joint targets.
#pragma once

#include <concepts>
#include <span>
#include <trophic/habitat/hinge_places.hpp>

#define TROPHIC_SENTENCE_Steering                                                                               \
  "void steer(double target_angle_rad, std::span<const HingePlace>, std::span<double> targets_rad) const; see " \
  "trophic/control/steering/contract.hpp"

namespace trophic::control {

/// `steer(target_angle_rad, hinges, targets_rad)`: changes the joint targets of one robot in place; one place and one target per
/// hinge. A rule that gives the targets of a straight walk for a turn is an error on a backend with joints, unless it declares
/// `static constexpr bool steers = false;`. A backend without joints asks no rule: robots turn by their model's `walk`, which is
/// measured with the rule that declares `static constexpr bool walks_use_it = true;`. Others are errors there.
template <class P>
concept Steering = requires(const P policy, double target_angle_rad, std::span<const HingePlace> hinges,
                            std::span<double> targets_rad) {
  { policy.steer(target_angle_rad, hinges, targets_rad) } -> std::same_as<void>;
};

}  // namespace trophic::control
