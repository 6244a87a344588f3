// SPDX-License-Identifier: MIT
// Notifies the policies that have a State of events.
#pragma once

#include <trophic/params/archive.hpp>
#include <trophic/population/state.hpp>
#include <trophic/rules/rule_states.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

namespace detail {

/// The hooks that a policy with a State may have, population/state.hpp. `P` is the policy of one species.
template <class P>
concept TakesWalk = requires(const P policy, StateOf<P>& own, BodyIndex body, const View& view) {
  policy.on_walk(own, body, 0.0, view);
};
template <class P>
concept TakesCatch = requires(const P policy, StateOf<P>& own, BodyIndex body, const View& view) {
  policy.on_catch(own, body, body, view);
};
template <class P>
concept TakesCaught = requires(const P policy, StateOf<P>& own, BodyIndex body, const View& view) {
  policy.on_caught(own, body, body, view);
};
template <class P>
concept TakesOtherDeath = requires(const P policy, StateOf<P>& own, BodyIndex body, const Vacancy& death, const View& view) {
  policy.on_other_death(own, body, death, view);
};
template <class P>
concept TakesSighting = requires(const P policy, StateOf<P>& own, BodyIndex body, const std::optional<Sighting>& sighting,
                                 const View& view) {
  policy.on_sighting(own, body, sighting, view);
};
template <class P>
concept TakesOffspring = requires(const P policy, StateOf<P>& own, BodyIndex body, const View& view) {
  policy.on_offspring(own, body, body, view);
};

/// Calls `call(policy, states)` for each policy with a State that `call` accepts: a lambda names the hook that it calls.
template <class Rules, class Call>
void for_each_with_hook(const Policies<Rules>& rules, RuleStates<Rules>& all, const Call& call) {
  for_each_state(rules, all, [&](const auto& policy, auto& states) {
    if constexpr (requires { call(policy, states); }) call(policy, states);
  });
}

}  // namespace detail

/// Writes the names of the rules with states, or compares them: states can be read only by the rules that wrote them.
template <class Rules>
void persist_keepers(Archive& archive, const Policies<Rules>& rules, RuleStates<Rules>& all) {
  std::string keepers;
  for_each_state(rules, all, [&](const auto& policy, auto&) { keepers.append(policy.name).push_back(' '); });
  std::string there = keepers;
  archive(there);
  Archive::require(there == keepers, "rules with different states");
}

/// All bodies have moved, from `before`.
template <class Rules>
void notify_walk(const Policies<Rules>& rules, RuleStates<Rules>& all, std::span<const GroundPose> before, const View& view) {
  detail::for_each_with_hook(
      rules, all, [&]<class P>(const P& policy, BodyStates<P>& states) -> void requires detail::TakesWalk<AnswersForSpecies<P>> {
        for (BodyIndex body = 0; body < view.robots.size(); ++body) {
          if (!view.robots[body].lives()) continue;
          const double walked_m = view.distance_m(before[body], view.poses[body]);
          for_species(policy, view.robots[body].species).on_walk(states[body], body, walked_m, view);
        }
      });
}

/// A hunter has caught a victim, which is still there.
template <class Rules>
void notify_catch(const Policies<Rules>& rules, RuleStates<Rules>& all, BodyIndex hunter, BodyIndex victim, const View& view) {
  detail::for_each_with_hook(
      rules, all, [&]<class P>(const P& policy, BodyStates<P>& states) -> void requires detail::TakesCatch<AnswersForSpecies<P>> {
        for_species(policy, view.robots[hunter].species).on_catch(states[hunter], hunter, victim, view);
      });
  detail::for_each_with_hook(
      rules,
      all, [&]<class P>(const P& policy, BodyStates<P>& states) -> void requires detail::TakesCaught<AnswersForSpecies<P>> {
        for_species(policy, view.robots[victim].species).on_caught(states[victim], victim, hunter, view);
      });
}

/// An individual, which is still there, has died.
template <class Rules>
void notify_death(const Policies<Rules>& rules, RuleStates<Rules>& all, const Vacancy& death, const View& view) {
  detail::for_each_with_hook(
      rules,
      all, [&]<class P>(const P& policy, BodyStates<P>& states) -> void requires detail::TakesOtherDeath<AnswersForSpecies<P>> {
        for (BodyIndex body = 0; body < view.robots.size(); ++body) {
          if (body == death.body || !view.robots[body].lives()) continue;
          for_species(policy, view.robots[body].species).on_other_death(states[body], body, death, view);
        }
      });
}

/// An individual has perceived its adversary, or none.
template <class Rules>
void notify_sighting(const Policies<Rules>& rules, RuleStates<Rules>& all, BodyIndex body,
                     const std::optional<Sighting>& sighting, const View& view) {
  detail::for_each_with_hook(
      rules,
      all, [&]<class P>(const P& policy, BodyStates<P>& states) -> void requires detail::TakesSighting<AnswersForSpecies<P>> {
        for_species(policy, view.robots[body].species).on_sighting(states[body], body, sighting, view);
      });
}

/// The individual in body `parent` has an offspring in body `newborn`.
template <class Rules>
void notify_offspring(const Policies<Rules>& rules, RuleStates<Rules>& all, BodyIndex parent, BodyIndex newborn,
                      const View& view) {
  detail::for_each_with_hook(
      rules, all, [&]<class P>(const P& policy, BodyStates<P>& states) -> void requires detail::HandsOver<AnswersForSpecies<P>> {
        for_species(policy, view.robots[parent].species).hand_over(states[parent], states[newborn], view);
      });
  detail::for_each_with_hook(
      rules,
      all, [&]<class P>(const P& policy, BodyStates<P>& states) -> void requires detail::TakesOffspring<AnswersForSpecies<P>> {
        for_species(policy, view.robots[parent].species).on_offspring(states[parent], parent, newborn, view);
      });
}

}  // namespace trophic
