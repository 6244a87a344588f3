// SPDX-License-Identifier: MIT
// Only active robots perceive, and only robots that show the same tag.
#pragma once

#include <trophic/perception/visibility/contract.hpp>

namespace trophic::perception::visibility {

/// Rule: self perceives other iff their tags are equal and both are active. The paper is silent: "the prey wanders around the map
/// in a state of inactivity and is invisible to all predators" (Sec. "Prey Death") does not settle whether such a newborn
/// perceives predators. SameTag, with which it does, is the alternative reading.   Reads: both tags, both activities.   Random
/// draws: 0.
struct SameTagIfActive {
  static constexpr std::string_view name = "same_tag_if_active";
  static constexpr std::string_view source = "paper: silent; a reading of Sec. \"Prey Death\"";
  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view, Rng&) const {
    const Individual& one = view.robots[self];
    const Individual& seen = view.robots[other];
    return one.active && seen.active && one.tag == seen.tag;
  }
  [[nodiscard]] Horizon horizon(const Individual& self) const { return {.tag = self.tag, .only_active = true}; }
};
static_assert(Visibility<SameTagIfActive>);

}  // namespace trophic::perception::visibility
