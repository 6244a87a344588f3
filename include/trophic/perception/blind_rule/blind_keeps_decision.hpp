// SPDX-License-Identifier: MIT
// Who perceives no adversary keeps doing what it did.
#pragma once

#include <string_view>
#include <trophic/perception/blind_rule/contract.hpp>

namespace trophic::perception::blind_rule {

/// Rule: no perceivable adversary: the brain is not run, target angle and tag stay (released code), so that a hidden robot
/// can never choose to show itself.   Reads: nothing.   Random draws: 0.
struct BlindKeepsDecision {
  static constexpr std::string_view name = "blind_keeps_decision";
  static constexpr std::string_view source = "released code";
  [[nodiscard]] bool decides() const { return false; }
};
static_assert(BlindRule<BlindKeepsDecision>);

}  // namespace trophic::perception::blind_rule
