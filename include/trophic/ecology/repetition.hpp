// SPDX-License-Identifier: MIT
// Drives a run of the neutral null: the births, deaths, activations and catches of another run replace the rules.
#pragma once

#include <trophic/ecology/history.hpp>
#include <trophic/ecology/turnover.hpp>

namespace trophic {

/// Repeats an experiment's history tick by tick. Without a history it does nothing.
template <class Rules>
class Repetition {
 public:
  /// Both must outlive it.
  Repetition(EcologyState<Rules>& all, Turnover<Rules>& turnover)
      : all_{all}, turnover_{turnover}, history_{all.params.history} {}

  [[nodiscard]] explicit operator bool() const { return static_cast<bool>(history_); }
  void persist(Archive& archive) { archive(history_); }

  /// Throws std::invalid_argument for a neutral null without a history.
  void check() const {
    if (all_.params.null == Null::neutral && !history_) throw std::invalid_argument{"a neutral null: needs the history of a run"};
  }

  /// Notes the founders. Throws std::invalid_argument for a history with different founders.
  void start() {
    for (const Individual& one : all_.population.individuals())
      if (history_ && one.lives()) history_.found(one);
  }

  /// Brings back bodies that diverged in the last tick, because their individuals live on.
  void bring_back() {
    for (BodyIndex body = 0; history_ && body < all_.population.individuals().size(); ++body)
      if (all_.population[body].lives() && !all_.is_there(body)) all_.bodies.embody(body, all_.population.individuals().size());
  }

  /// Repeats what happened up to this tick.
  void tick(observe::Audience& audience) {
    auto& population = all_.population;
    while (const Happening* const next = history_.next(all_.tick)) {
      const Happening& event = *next;
      const auto other = event.killer_or_victim ? population.body_of(*event.killer_or_victim) : std::nullopt;
      if (event.kind == observe::EventKind::birth) {
        repeat_birth(audience, event);
      } else if (event.kind == observe::EventKind::death) {
        turnover_.emit_death(audience, {.body = event.body, .cause = *event.cause, .killer = other, .successor = {}});
        population.vacate(event.body);
        if (grows<Rules> && !history_.goes_on_in(event.body)) all_.bodies.take_away(event.body);
      } else if (event.kind == observe::EventKind::activation) {
        const auto& states = population.states().activation;
        const auto rule = death::ask::activates(all_.rules.activation, states[event.body], event.body, all_.view());
        population.activate(event.body, all_.time_s(), rule == death::Activates::yes_and_restarts_age);
        turnover_.emit(audience, observe::EventKind::activation, event.body);
      } else if (event.kind == observe::EventKind::capture && other) {
        population.feed(event.body, *other, all_.view());
        turnover_.emit(audience, observe::EventKind::capture, event.body, {}, event.killer_or_victim);
      }
    }
  }

 private:
  void repeat_birth(observe::Audience& audience, const Happening& birth) {
    using reproduction::Descent;
    const Descent orphan = birth.origin == Origin::inherited ? Descent::of_parent_in_name : Descent::random;
    const Parentage parentage{.descent = birth.parents.empty() ? orphan : Descent::of_parent,
                              .parents = history_.parents_of(birth)};
    std::optional<GroundPose> place;
    if (!all_.is_there(birth.body)) place = turnover_.place_of_birth(parentage.parents).value_or(all_.bodies.poses()[birth.body]);
    all_.population.replace(birth.body, birth.species, parentage, all_.view());
    history_.note_birth(all_.population[birth.body]);
    turnover_.begin_life(audience, birth.body, place);
  }

  EcologyState<Rules>& all_;
  Turnover<Rules>& turnover_;
  RepeatedHistory history_;
};

}  // namespace trophic
