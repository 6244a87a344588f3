// SPDX-License-Identifier: MIT
// Notifies the policies that have a State of what happened to its individuals.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/rules/rule_states.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

/// All bodies have moved, from `before`.
template <class Rules>
void notify_walk(const Policies<Rules>& rules, RuleStates<Rules>& all, std::span<const GroundPose> before, const View& view) {
  for_each_state(rules, all, [&](const auto& policy, auto& states) {
    if constexpr (requires { for_species(policy, Species{}).on_walk(states[0], BodyIndex{}, 0.0, view); }) {
      for (BodyIndex body = 0; body < view.robots.size(); ++body) {
        if (!view.robots[body].lives()) continue;
        const double walked_m = view.distance_m(before[body], view.poses[body]);
        for_species(policy, view.robots[body].species).on_walk(states[body], body, walked_m, view);
      }
    }
  });
}

/// A hunter has caught a victim, which is still there.
template <class Rules>
void notify_catch(const Policies<Rules>& rules, RuleStates<Rules>& all, BodyIndex hunter, BodyIndex victim, const View& view) {
  for_each_state(rules, all, [&](const auto& policy, auto& states) {
    const auto& of_hunter = for_species(policy, view.robots[hunter].species);
    if constexpr (requires { of_hunter.on_catch(states[hunter], hunter, victim, view); }) {
      of_hunter.on_catch(states[hunter], hunter, victim, view);
    }
    const auto& of_victim = for_species(policy, view.robots[victim].species);
    if constexpr (requires { of_victim.on_caught(states[victim], victim, hunter, view); }) {
      of_victim.on_caught(states[victim], victim, hunter, view);
    }
  });
}

/// An individual, which is still there, has died.
template <class Rules>
void notify_death(const Policies<Rules>& rules, RuleStates<Rules>& all, const Vacancy& death, const View& view) {
  for_each_state(rules, all, [&](const auto& policy, auto& states) {
    if constexpr (requires { for_species(policy, Species{}).on_other_death(states[0], BodyIndex{}, death, view); }) {
      for (BodyIndex body = 0; body < view.robots.size(); ++body) {
        if (body == death.body || !view.robots[body].lives()) continue;
        for_species(policy, view.robots[body].species).on_other_death(states[body], body, death, view);
      }
    }
  });
}

/// An individual has perceived its adversary, or none.
template <class Rules>
void notify_sighting(const Policies<Rules>& rules, RuleStates<Rules>& all, BodyIndex body,
                     const std::optional<Sighting>& sighting, const View& view) {
  for_each_state(rules, all, [&](const auto& policy, auto& states) {
    const auto& rule = for_species(policy, view.robots[body].species);
    if constexpr (requires { rule.on_sighting(states[body], body, sighting, view); }) {
      rule.on_sighting(states[body], body, sighting, view);
    }
  });
}

/// The individual in body `parent` has offspring in body `newborn`.
template <class Rules>
void notify_offspring(const Policies<Rules>& rules, RuleStates<Rules>& all, BodyIndex parent, BodyIndex newborn,
                      const View& view) {
  for_each_state(rules, all, [&]<class P>(const P& policy, auto& states) {
    const auto& rule = for_species(policy, view.robots[parent].species);
    if constexpr (detail::HandsOver<AnswersForSpecies<P>>) rule.hand_over(states[parent], states[newborn], view);
    if constexpr (requires { rule.on_offspring(states[parent], parent, newborn, view); }) {
      rule.on_offspring(states[parent], parent, newborn, view);
    }
  });
}

}  // namespace trophic
