// SPDX-License-Identifier: MIT
// The contract of a slot: how fast a robot walks.
#pragma once

#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_Pace "double pace(BodyIndex self, const View&) const; see trophic/control/pace/contract.hpp"

namespace trophic::control {

/// `pace(self, view)`: returns the factor of the frequency of a robot's gait in the next tick, on a backend of points of speed
/// and turning rate, >= 0: at 0 it stands. The act Effort, if the table has it, multiplies it.
template <class P>
concept Pace = requires(const P policy, BodyIndex self, const View& view) {
  { policy.pace(self, view) } -> std::same_as<double>;
};

}  // namespace trophic::control
