// SPDX-License-Identifier: MIT
// Brains decide one after the other.
#pragma once

#include <string_view>
#include <trophic/control/decision_order/contract.hpp>

namespace trophic::control::decision_order {

/// Rule (released code): brains decide in the order of bodies, and whoever comes later already sees the tags that earlier ones
/// have taken at this tick. The tag ratio is that of the tick's start for all.   Reads: nothing.   Random draws: 0.
struct DecideInTurn {
  static constexpr std::string_view name = "decide_in_turn";
  static constexpr std::string_view source = "released code";
  [[nodiscard]] bool in_turn() const { return true; }
};
static_assert(DecisionOrder<DecideInTurn>);

}  // namespace trophic::control::decision_order
