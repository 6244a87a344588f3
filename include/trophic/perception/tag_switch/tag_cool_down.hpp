// SPDX-License-Identifier: MIT
// A cool-down between two tag switches.
#pragma once

#include <trophic/perception/tag_switch/contract.hpp>

namespace trophic::perception::tag_switch {

/// Rule: the tag may change iff at least cool_down has passed since the last switch or, before the first, since birth (Sec.
/// "Tagging System": 50 s). As in the released code, the cool-down also starts at birth; the paper is silent, and FirstSwitchFree
/// is the alternative reading. The released code uses TagSampling.   Reads: own tag clock, time.   Random draws: 0.
struct TagCoolDown {
  static constexpr std::string_view name = "tag_cool_down";
  static constexpr std::string_view source = "paper, Sec. \"Tagging System\"";

  struct Params {
    double cool_down_s = 50.0;
    static constexpr auto fields() {
      return std::tuple{field("cool_down_s", &Params::cool_down_s, at_least(0.0), "minimum time between two tag switches")};
    }
  };
  Params params;

  [[nodiscard]] MaySwitch may_switch(const Individual& self, const View& view) const {
    return view.passed(self.tag_since_s, params.cool_down_s) ? MaySwitch::yes : MaySwitch::no;
  }
};
static_assert(TagSwitch<TagCoolDown>);

}  // namespace trophic::perception::tag_switch
