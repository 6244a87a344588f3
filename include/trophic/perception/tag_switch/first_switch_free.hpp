// SPDX-License-Identifier: MIT
// A cool-down between two tag switches, but none before the first.
#pragma once

#include <trophic/perception/tag_switch/contract.hpp>

namespace trophic::perception::tag_switch {

/// Rule: the tag may change iff it has not changed since birth, or at least cool_down has passed since the last switch. The
/// paper is silent: in "a cool-down of 50 seconds before a robot may switch its tag again" (Sec. "Tagging System") *again* may
/// mean that the first switch is free. TagCoolDown, whose cool-down also starts at birth, is the alternative reading. The rule
/// has a state, because a switch at the tick of birth leaves the tag clock at the time of birth.   Reads: its own state, own tag,
/// own tag clock, time.   Random draws: 0.
struct FirstSwitchFree {
  static constexpr std::string_view name = "first_switch_free";
  static constexpr std::string_view source = "paper: silent; a reading of Sec. \"Tagging System\"";

  struct Params {
    double cool_down_s = 50.0;
    static constexpr auto fields() {
      return std::tuple{field("cool_down_s", &Params::cool_down_s, at_least(0.0), "minimum time between two tag switches")};
    }
  };
  Params params;

  /// Per individual.
  struct State {
    int newborn_tag = 0;
    bool has_switched = false;
    static constexpr auto fields() {
      return std::tuple{field("newborn_tag", &State::newborn_tag), field("has_switched", &State::has_switched)};
    }
  };
  [[nodiscard]] State born(const Individual& newborn, const State*, const State&) const {
    return {.newborn_tag = newborn.tag, .has_switched = false};
  }
  void on_sighting(State& own, BodyIndex self, const std::optional<Sighting>&, const View& view) const {
    own.has_switched = own.has_switched || view.robots[self].tag != own.newborn_tag;
  }

  [[nodiscard]] MaySwitch may_switch(const Individual& self, const View& view, const State& own) const {
    return !own.has_switched || view.passed(self.tag_since_s, params.cool_down_s) ? MaySwitch::yes : MaySwitch::no;
  }
};
static_assert(TagSwitch<FirstSwitchFree>);

}  // namespace trophic::perception::tag_switch
