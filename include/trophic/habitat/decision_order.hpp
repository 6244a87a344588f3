// SPDX-License-Identifier: MIT
// The order of robots' decisions within a tick.
#pragma once

#include <array>
#include <string_view>

namespace trophic {

/// `together`: all robots perceive the same moment, before the first tag of the tick changes, so that the order of bodies does
/// not matter. `in_turn`: robots decide in the order of bodies, and each sees the tags that earlier ones have chosen at this
/// tick, as in the released code. The paper is silent. Common sensors are evaluated at the tick's start in both.
enum class DecisionOrder { together, in_turn };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(DecisionOrder) {
  return {"together", "in_turn"};
}

}  // namespace trophic
