// SPDX-License-Identifier: MIT
// All robots walk at the pace of their gait.
#pragma once

#include <trophic/control/pace/contract.hpp>

namespace trophic::control::pace {

/// Rule: 1 (the paper).   Reads: nothing.   Random draws: 0.
struct SamePace {
  static constexpr std::string_view name = "same_pace";
  static constexpr std::string_view source = "paper: no such rule";
  [[nodiscard]] double pace(BodyIndex, const View&) const { return 1.0; }
};
static_assert(Pace<SamePace>);

}  // namespace trophic::control::pace
