// SPDX-License-Identifier: MIT
// Unrestricted tag switches.
#pragma once

#include <trophic/perception/tag_switch/contract.hpp>

namespace trophic::perception::tag_switch {

/// Rule: the tag may change at every decision. This is the control for the effect of the cool-down.   Reads: nothing.   Random
/// draws: 0.
struct FreeTags {
  static constexpr std::string_view name = "free_tags";
  static constexpr std::string_view source = "control";
  [[nodiscard]] MaySwitch may_switch(const Individual&, const View&) const { return MaySwitch::yes; }
};
static_assert(TagSwitch<FreeTags>);

}  // namespace trophic::perception::tag_switch
