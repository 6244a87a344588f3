// SPDX-License-Identifier: MIT
// Without an adversary nothing is decided: target angle and tag freeze.
#pragma once

#include <optional>
#include <string_view>
#include <trophic/perception/blind_rule/contract.hpp>

namespace trophic::perception::blind_rule {

/// Rule: no perceivable adversary: the brain is not run, target angle and tag stay (released code), so that a hidden robot
/// can never choose to show itself.   Reads: nothing.   Random draws: 0.
struct BlindKeepsOutputs {
  static constexpr std::string_view name = "blind_keeps_outputs";
  [[nodiscard]] std::optional<BrainInputs> inputs(double) const { return std::nullopt; }
};
static_assert(BlindRule<BlindKeepsOutputs>);

}  // namespace trophic::perception::blind_rule
