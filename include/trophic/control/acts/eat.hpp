// SPDX-License-Identifier: MIT
// Whether a robot eats.
#pragma once

#include <trophic/control/acts/contract.hpp>

namespace trophic::control::acts {

/// Rule: the robot bites if the output is positive; only then does metabolism::GrazingAndHunting take from the resource. In a
/// table without this act all robots bite. Eating has its own output, as in Polyworld [yaeger1994].   Reads: its output.   Random
/// draws: 0.
struct Eat : YesOrNo {
  static constexpr std::string_view name = "eat";
  static constexpr std::string_view source = "not in the paper; [yaeger1994]";
  static constexpr bool by_default = true;
};
static_assert(Act<Eat>);

}  // namespace trophic::control::acts
