// SPDX-License-Identifier: MIT
// The released code's tag clock: the brain's tag is sampled periodically.
#pragma once

#include <trophic/perception/tag_switch/contract.hpp>

namespace trophic::perception::tag_switch {

/// Rule (released code: every 100 s): at the first decision at least `period` after the tag clock's start the robot takes the
/// brain's tag, and the clock restarts whether or not the tag has changed. A brain thus chooses a tag once per period; with
/// TagCoolDown it may choose at every tick after the cool-down. The clock starts at birth.   Reads: own tag clock, time.   Random
/// draws: 0.
struct TagSampling {
  static constexpr std::string_view name = "tag_sampling";
  static constexpr std::string_view source = "released code";

  struct Params {
    double period_s = 100.0;
    static constexpr auto fields() {
      return std::tuple{field("period_s", &Params::period_s, at_least(0.0), "time between two samples of the brain's tag")};
    }
  };
  Params params;

  [[nodiscard]] MaySwitch may_switch(const Individual& self, const View& view) const {
    return view.passed(self.tag_since_s, params.period_s) ? MaySwitch::yes_and_clock_restarts : MaySwitch::no;
  }
};
static_assert(TagSwitch<TagSampling>);

}  // namespace trophic::perception::tag_switch
