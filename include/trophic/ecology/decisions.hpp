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

  /// Lets all robots perceive and decide by the brains of their genomes. `now` refers to the individuals, so it shows each change
  /// at once.
  void make(observe::Audience& audience, const View& now) {
    for (begin(now); sense(now); act(audience, now)) ask_brains();
  }

  /// Begins a tick.
  void begin(const View& now) {
    common_.emplace(rules_.sensors.sense_common(now));
    choices_.resize(population_.individuals().size());
    next_ = 0;
  }

  /// Lets the next robots of the tick perceive: one if they decide in turn; else all, the same moment, so that all decisions are
  /// made before the first tag changes. Returns false after the last.
  [[nodiscard]] bool sense(const View& now) {
    const Moment<Rules> moment{rules_, population_, seed_, now};
    const auto perceive = [&](BodyIndex body) { moment.perceive(body, *common_, params_.without_target, choices_[body]); };
    asked_.clear();
    first_ = next_;
    if (params_.decision_order == DecisionOrder::in_turn) {
      while (first_ < choices_.size() && !population_[first_].lives()) ++first_;
      next_ = std::min(first_ + 1, choices_.size());
      if (first_ < next_) perceive(first_);
    } else {
      next_ = choices_.size();
      for (std::size_t i = first_; i < next_; ++i) {
        const BodyIndex body = now.tree == nullptr ? i : now.tree->by_place(i);  // neighbours perceive the same robots
        if (population_[body].lives()) perceive(body);
      }
    }
    for (BodyIndex body = first_; body < next_; ++body)
      if (population_[body].lives() && choices_[body].is_asked) asked_.push_back(body);
    return first_ < next_;
  }

  /// The robots that perceived and whose brains decide.
  [[nodiscard]] std::span<const BodyIndex> asked() const { return asked_; }
  [[nodiscard]] Choice<Rules>& choice(BodyIndex body) { return choices_[body]; }

  /// Sets the outputs by the brains of their genomes.
  void ask_brains() { population_.ask_brains(asked_, choices_); }

  /// Lets those that perceived do what the outputs stand for.
  void act(observe::Audience& audience, const View& now) {
    decided_.clear();
    for (const BodyIndex body : asked_) decided_.push_back(population_.decision(body, choices_[body].outputs));
    auto decision = decided_.begin();
    for (BodyIndex body = first_; body < next_; ++body) {
      if (!population_[body].lives()) continue;
      population_.sight(body, choices_[body].sighting, now);
      if (choices_[body].is_asked) act(audience, body, *decision++, now);
    }
  }

 private:
  static constexpr bool shows_outputs = control::EvaluatesOutputs<typename Population<Rules>::Brain>;

  void act(observe::Audience& audience, BodyIndex body, const control::Decision& decision, const View& now) {
    const Individual& self = population_[body];
    const Choice<Rules>& choice = choices_[body];
    const int tag_before = self.tag;
    population_.turn(body, decision.target_angle_rad);
    population_.acts().act(body, choice.outputs);
    using perception::MaySwitch;
    const MaySwitch may_switch = perception::ask::may_switch(rules_.tag_switch, population_.states().tag_switch[body], self, now);
    if (may_switch != MaySwitch::no) {
      show_tag(audience, body, decision.tag, may_switch == MaySwitch::yes_and_clock_restarts, now);
    }
    audience.decision({.body = body,
                       .inputs = population_.inputs_of(body, choice.inputs),
                       .outputs = shows_outputs ? std::span<const double>{choice.outputs} : std::span<const double>{},
                       .target_angle_rad = decision.target_angle_rad,
                       .tag = decision.tag,
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
  std::vector<Choice<Rules>> choices_;  ///< by body
  /// Of the tick: the sensors that are the same for all robots.
  std::optional<decltype(std::declval<const PolicyIn<Rules, RuleSlot::sensors>&>().sense_common(std::declval<const View&>()))>
      common_;
  BodyIndex first_ = 0;  ///< of those that perceived
  BodyIndex next_ = 0;   ///< the first that has not yet perceived
  std::vector<BodyIndex> asked_;
  std::vector<control::Decision> decided_;
};

}  // namespace trophic
