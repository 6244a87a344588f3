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

/// `steer(target_angle_rad, hinges, targets_rad)`: changes the joint targets of one robot in place, with one place and one target
/// per hinge. On a backend with joints, a rule whose targets for a turn equal those of a straight walk is an error, unless it
/// declares `static constexpr bool steers = false;`. A backend without joints uses no steering rule: robots turn as in their
/// model's `walk`, which is measured with the rule that declares `static constexpr bool walks_use_it = true;`. Other rules are
/// errors there.
template <class P>
concept Steering = requires(const P policy, double target_angle_rad, std::span<const HingePlace> hinges,
                            std::span<double> targets_rad) {
  { policy.steer(target_angle_rad, hinges, targets_rad) } -> std::same_as<void>;
};

}  // namespace trophic::control
