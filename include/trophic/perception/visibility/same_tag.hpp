// SPDX-License-Identifier: MIT
// Only robots that show the same tag perceive each other.
#pragma once

#include <trophic/perception/visibility/contract.hpp>

namespace trophic::perception::visibility {

/// Rule: self perceives other iff their tags are equal and other is active (Sec. "Tagging System"; an inactive newborn is
/// invisible: Sec. "Prey Death"). The paper is silent on what an inactive newborn perceives; SameTagIfActive is the alternative
/// reading.   Reads: both tags, other's activity.   Random draws: 0.
struct SameTag {
  static constexpr std::string_view name = "same_tag";
  static constexpr std::string_view source = "paper, Sec. \"Tagging System\"";
  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view, Rng&) const {
    return view.robots[self].tag == view.robots[other].tag && view.robots[other].active;
  }
  [[nodiscard]] Horizon horizon(const Individual& self) const { return {.tag = self.tag, .only_active = true}; }
};
static_assert(Visibility<SameTag>);

}  // namespace trophic::perception::visibility
