// SPDX-License-Identifier: MIT
// Who perceives no adversary decides all the same.
#pragma once

#include <string_view>
#include <trophic/perception/blind_rule/contract.hpp>

namespace trophic::perception::blind_rule {

/// Rule: no perceivable adversary: the brain decides all the same. The paper queries it every 2 s (Sec. "Outputs").   Reads:
/// nothing.   Random draws: 0.
struct BlindDecides {
  static constexpr std::string_view name = "blind_decides";
  static constexpr std::string_view source = "paper, Sec. \"Outputs\"";
  [[nodiscard]] bool decides() const { return true; }
};
static_assert(BlindRule<BlindDecides>);

}  // namespace trophic::perception::blind_rule
