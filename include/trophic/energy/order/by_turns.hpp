// SPDX-License-Identifier: MIT
// Species act in turn.
#pragma once

#include <trophic/energy/order/contract.hpp>
#include <trophic/params/params.hpp>

namespace trophic::energy::order {

/// `in_turn`: one species after another; `together`: as in a table without the rule.
enum class Acts { in_turn, together };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Acts) {
  return {"in_turn", "together"};
}

/// Rule: a species completes all its acts of a tick before the next species, as in NetLogo's wolf sheep predation [wilensky1997].
/// There, each individual completes all its acts before the next one. Both have the same distribution if members of a species
/// interact only through the remaining food, which they eat in random order.   Reads: nothing.   Random draws: 0.
struct ByTurns {
  static constexpr std::string_view name = "by_turns";
  static constexpr std::string_view source = "not in the paper; [wilensky1997]";

  struct Params {
    Acts acts = Acts::in_turn;
    static constexpr auto fields() {
      return std::tuple{field("acts", &Params::acts, "in_turn, or together (as in a table without this rule)")};
    }
  };
  Params params;

  [[nodiscard]] bool in_turn() const { return params.acts == Acts::in_turn; }
};
static_assert(Order<ByTurns>);

}  // namespace trophic::energy::order
