// SPDX-License-Identifier: MIT
// What a robot does that perceives no adversary.
#pragma once

#include <array>
#include <string_view>

namespace trophic {

/// `decides`: the brain decides all the same; the paper queries it every 2 s (Sec. "Outputs"). `keeps_decision`: the brain is not
/// run, target angle and tag stay, as in the released code; so a hidden robot can never choose to show itself. What sensors say
/// without an adversary is each sensor's own.
enum class WithoutTarget { decides, keeps_decision };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(WithoutTarget) {
  return {"decides", "keeps_decision"};
}

}  // namespace trophic
