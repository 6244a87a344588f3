// SPDX-License-Identifier: MIT
// Perception and decisions of all robots at a tick, and their consequences.
#pragma once

#include <trophic/ecology/choice.hpp>
#include <trophic/observe/audience.hpp>
#include <trophic/perception/tag_switch/contract.hpp>

namespace trophic {

/// Lets the individuals of a population perceive and decide.
template <class Rules>
class Decisions {
 public:
  /// All arguments must outlive it.
  Decisions(const EcologyParams& params, const Policies<Rules>& rules, std::uint64_t seed, Population<Rules>& population)
      : params_{params}, rules_{rules}, seed_{seed}, population_{population} {}

  /// Unless robots decide in turn, all perceive the same moment: all decisions are made before the first tag changes. `now`
  /// refers to the individuals, so it shows each change at once.
  void make(observe::Audience& audience, const View& now) {
    const Moment<Rules> moment{rules_, population_, seed_, now};
    const auto common = rules_.sensors.sense_common(now);
    choices_.resize(population_.individuals().size());
    const bool in_turn = params_.decision_order == DecisionOrder::in_turn;
    for (std::size_t i = 0; i < choices_.size() && !in_turn; ++i) {
      const BodyIndex body = now.tree == nullptr ? i : now.tree->by_place(i);  // neighbours perceive the same robots
      if (population_[body].lives()) choices_[body] = moment.perception(body, common, params_.without_target);
    }
    for (BodyIndex body = 0; body < choices_.size(); ++body) {
      if (!population_[body].lives()) continue;
      if (in_turn) choices_[body] = moment.perception(body, common, params_.without_target);
      moment.decide(body, choices_[body], params_.without_target);
      if (in_turn) act(audience, body, choices_[body], now);
    }
    for (BodyIndex body = 0; body < choices_.size() && !in_turn; ++body) act(audience, body, choices_[body], now);
  }

 private:
  static constexpr bool shows_outputs = control::EvaluatesOutputs<typename Population<Rules>::Brain>;

  void act(observe::Audience& audience, BodyIndex body, const Choice<Rules>& choice, const View& now) {
    if (!population_[body].lives()) return;
    population_.sight(body, choice.sighting, now);
    if (!choice.decision) return;
    const Individual& self = population_[body];
    const int tag_before = self.tag;
    population_.turn(body, choice.decision->target_angle_rad);
    population_.acts().act(body, choice.outputs);
    using perception::MaySwitch;
    const MaySwitch may_switch = perception::ask::may_switch(rules_.tag_switch, population_.states().tag_switch[body], self, now);
    if (may_switch != MaySwitch::no) {
      show_tag(audience, body, choice.decision->tag, may_switch == MaySwitch::yes_and_clock_restarts, now);
    }
    audience.decision({.body = body,
                       .inputs = std::span{choice.inputs}.first(Population<Rules>::Sensors::size_of(self.species)),
                       .outputs = shows_outputs ? std::span<const double>{choice.outputs} : std::span<const double>{},
                       .target_angle_rad = choice.decision->target_angle_rad,
                       .tag = choice.decision->tag,
                       .tag_before = tag_before,
                       .might_switch = may_switch != MaySwitch::no},
                      now);
  }

  void show_tag(observe::Audience& audience, BodyIndex body, int tag, bool restarts_clock, const View& now) {
    const bool switched = tag != population_[body].tag;
    population_.show_tag(body, tag);
    if (switched || restarts_clock) population_.restart_tag_clock(body, now.time_s);
    if (!switched) return;
    audience.event(
        observe::Event{
            .kind = observe::EventKind::tag_switch, .body = body, .individual = population_[body], .cause = {}, .other = {}},
        now);
  }

  const EcologyParams& params_;
  const Policies<Rules>& rules_;
  std::uint64_t seed_;
  Population<Rules>& population_;
  std::vector<Choice<Rules>> choices_;
};

}  // namespace trophic
