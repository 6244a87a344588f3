// SPDX-License-Identifier: MIT
// Without an adversary the brain still runs, on neutral inputs.
#pragma once

#include <optional>
#include <string_view>
#include <trophic/perception/blind_rule/contract.hpp>

namespace trophic::perception::blind_rule {

/// Rule: no perceivable adversary: angle 0 (neither side), distance 1 (as far as can be), tag ratio as always. The paper
/// queries the brain every 2 s (Sec. "Outputs") and is silent about what it is told then.   Reads: tag
/// ratio.   Random draws: 0.
struct BlindSeesNothing {
  static constexpr std::string_view name = "blind_sees_nothing";
  [[nodiscard]] std::optional<BrainInputs> inputs(double tag_ratio) const {
    return BrainInputs{.angle = 0.0, .distance = 1.0, .tag_ratio = tag_ratio};
  }
};
static_assert(BlindRule<BlindSeesNothing>);

}  // namespace trophic::perception::blind_rule
