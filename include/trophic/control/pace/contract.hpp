// SPDX-License-Identifier: MIT
// The contract of a slot: how fast a robot walks.
#pragma once

#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_Pace "double pace(BodyIndex self, const View&) const; see trophic/control/pace/contract.hpp"

namespace trophic::control {

/// `pace(self, view)`: returns the factor, >= 0, that multiplies the frequency of a robot's gait in the next tick or, on a
/// backend of points, its speed and turning rate; at 0 the robot stands still. The act Effort, if the table has it, is a further
/// factor.
template <class P>
concept Pace = requires(const P policy, BodyIndex self, const View& view) {
  { policy.pace(self, view) } -> std::same_as<double>;
};

}  // namespace trophic::control
