// SPDX-License-Identifier: MIT
// The decision of a robot that perceives no adversary.
#pragma once

#include <array>
#include <string_view>

namespace trophic {

/// `decides`: the brain decides as usual; the paper queries it every 2 s (Sec. "Outputs"). `keeps_decision`: the brain is not
/// run, and target angle and tag stay, as in the released code; so a hidden robot can never choose to show itself. Each sensor
/// defines its value without an adversary.
enum class WithoutTarget { decides, keeps_decision };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(WithoutTarget) {
  return {"decides", "keeps_decision"};
}

}  // namespace trophic
