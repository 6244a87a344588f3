// SPDX-License-Identifier: MIT
// Three rules for tag switches, chosen by a number.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/perception/tag_switch/first_switch_free.hpp>
#include <trophic/perception/tag_switch/tag_cool_down.hpp>
#include <trophic/perception/tag_switch/tag_sampling.hpp>

namespace trophic::readings {

enum class TagRule { cool_down, first_free, sampling };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(TagRule) {
  return {"cool_down", "first_free", "sampling"};
}

/// Behaves as TagCoolDown, FirstSwitchFree or TagSampling, with the State of FirstSwitchFree. Either explains the purpose.
struct AnyTagSwitch {
  using Free = perception::tag_switch::FirstSwitchFree;
  static constexpr std::string_view name = "any_tag_switch";

  struct Params {
    TagRule reading = TagRule::cool_down;
    double cool_down_s = 50.0;  ///< of both cool-downs
    double period_s = 100.0;    ///< of sampling
    static constexpr auto fields() {
      return std::tuple{field("reading", &Params::reading, "cool_down, first_free or sampling"),
                        field("cool_down_s", &Params::cool_down_s, at_least(0.0), "pause between two tag switches"),
                        field("period_s", &Params::period_s, at_least(0.0), "time between two samples of the brain's tag")};
    }
  };
  Params params;

  using State = Free::State;
  [[nodiscard]] State born(const Individual& newborn, const State* parent, const State& body) const {
    return Free{}.born(newborn, parent, body);
  }
  void on_sighting(State& own, BodyIndex self, const std::optional<Sighting>& sighting, const View& view) const {
    Free{}.on_sighting(own, self, sighting, view);
  }

  [[nodiscard]] perception::MaySwitch may_switch(const Individual& self, const View& view, const State& own) const {
    if (params.reading == TagRule::sampling) return perception::tag_switch::TagSampling{{params.period_s}}.may_switch(self, view);
    if (params.reading == TagRule::first_free) return Free{{params.cool_down_s}}.may_switch(self, view, own);
    return perception::tag_switch::TagCoolDown{{params.cool_down_s}}.may_switch(self, view);
  }
};
static_assert(perception::TagSwitch<AnyTagSwitch>);

}  // namespace trophic::readings
