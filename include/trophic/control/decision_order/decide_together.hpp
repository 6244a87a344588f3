// SPDX-License-Identifier: MIT
// All brains decide on the same moment.
#pragma once

#include <string_view>
#include <trophic/control/decision_order/contract.hpp>

namespace trophic::control::decision_order {

/// Rule: everybody perceives before the first tag of the tick changes, so that the order of bodies does not matter. The paper is
/// silent.   Reads: nothing.   Random draws: 0.
struct DecideTogether {
  static constexpr std::string_view name = "decide_together";
  static constexpr std::string_view source = "paper: silent";
  [[nodiscard]] bool in_turn() const { return false; }
};
static_assert(DecisionOrder<DecideTogether>);

}  // namespace trophic::control::decision_order
