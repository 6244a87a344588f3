// SPDX-License-Identifier: MIT
// Whether a robot chooses to mate.
#pragma once

#include <trophic/control/acts/contract.hpp>

namespace trophic::control::acts {

/// Rule: the robot chooses to mate if the output is positive; recruitment::ByMating needs this of both parents, as in Polyworld
/// [yaeger1994].   Reads: its output.   Random draws: 0.
struct Mate : YesOrNo {
  static constexpr std::string_view name = "mate";
  static constexpr std::string_view source = "not in the paper; [yaeger1994]";
  static constexpr bool by_default = true;
};
static_assert(Act<Mate>);

}  // namespace trophic::control::acts
