// SPDX-License-Identifier: MIT
// The states of all rules of a table.
#pragma once

#include <string_view>
#include <trophic/population/state.hpp>
#include <trophic/rules/table.hpp>
#include <type_traits>

namespace trophic {

namespace detail {

/// Fails to compile, with one sentence, if a policy with a State is not what population/state.hpp asks for.
template <class Rules>
struct CheckStates {
#define TROPHIC_CHECK_STATE_HOOK(hook, Happened, signature)                                                  \
  static_assert(!StateNames_##hook<Policy> || Stateful<Policy>, "a policy has " #hook                        \
                                                                " but no State, so it would never be "       \
                                                                "called; see trophic/population/state.hpp"); \
  static_assert(!StateNames_##hook<Policy> || !Stateful<Policy> || StateTakes_##hook<Policy>,                \
                "a policy's " #hook " must be callable as " signature " const; see trophic/population/state.hpp");
  template <class Policy>
  struct Hooks {
    TROPHIC_STATE_HOOKS(TROPHIC_CHECK_STATE_HOOK)
    static constexpr bool ok = true;
  };
#undef TROPHIC_CHECK_STATE_HOOK

#define TROPHIC_CHECK_STATE(Slot, member, kind, Contract)                                                                     \
  using Slot = typename slot_##member<Rules>::type;                                                                           \
  static_assert(                                                                                                              \
      !Stateful<Slot> || (Parameters<StateOf<Slot>> && OpenParams<StateOf<Slot>> &&                                           \
                          AllListed<members_of<StateOf<Slot>>, fields_of<StateOf<Slot>>> && listed_once<StateOf<Slot>>()),    \
      "the State of the policy in Rules::" #Slot                                                                              \
      " must be an aggregate that lists every member once in fields(), as Params do; see trophic/population/state.hpp");      \
  static_assert(!Stateful<Slot> || only_state_members<StateOf<Slot>>(),                                                       \
                "the State of the policy in Rules::" #Slot                                                                    \
                " may hold numbers, enumerations, Ancestors, each also optional, and vectors of numbers: what can be saved"); \
  static_assert(!Stateful<Slot> || BornWithState<Slot>,                                                                       \
                "the policy in Rules::" #Slot                                                                                 \
                " has a State, so it needs State born(const Individual& newborn, const State* parent, const State& body) "    \
                "const: what a newborn starts with; see trophic/population/state.hpp");                                       \
  static_assert(Hooks<Slot>::ok);
  TROPHIC_RULE_SLOTS(TROPHIC_CHECK_STATE)
#undef TROPHIC_CHECK_STATE
  static constexpr bool ok = true;
};

template <class Rules>
[[nodiscard]] consteval bool has_states() {
#define TROPHIC_HAS_STATE(Slot, member, kind, Contract) || Stateful<typename slot_##member<Rules>::type>
  return false TROPHIC_RULE_SLOTS(TROPHIC_HAS_STATE);
#undef TROPHIC_HAS_STATE
}

}  // namespace detail

/// The states of all rules of a table, one member per slot. The population writes them, others read.
template <class Rules>
struct RuleStates {
  static_assert(detail::CheckStates<Rules>::ok);
#define TROPHIC_STATES(Slot, member, kind, Contract) \
  [[no_unique_address]] BodyStates<typename detail::slot_##member<Rules>::type> member;
  TROPHIC_RULE_SLOTS(TROPHIC_STATES)
#undef TROPHIC_STATES
};

/// Calls `visit(slot_name, states)` for each slot whose policy has a State.
template <class Rules, class Visitor>
void for_each_state(const RuleStates<Rules>& states, [[maybe_unused]] Visitor&& visit) {
#define TROPHIC_VISIT_STATE(Slot, member, kind, Contract)                \
  if constexpr (Stateful<typename detail::slot_##member<Rules>::type>) { \
    visit(std::string_view{#member}, states.member);                     \
  }
  TROPHIC_RULE_SLOTS(TROPHIC_VISIT_STATE)
#undef TROPHIC_VISIT_STATE
}

/// Calls `visit(policy, states)` for each slot whose policy has a State. One that lacks `born` has been reported above.
template <class Rules, class Visitor>
void for_each_state(const Policies<Rules>& rules, RuleStates<Rules>& states, [[maybe_unused]] Visitor&& visit) {
#define TROPHIC_VISIT_STATE(Slot, member, kind, Contract)                             \
  if constexpr (detail::BornWithState<typename detail::slot_##member<Rules>::type>) { \
    visit(rules.member, states.member);                                               \
  }
  TROPHIC_RULE_SLOTS(TROPHIC_VISIT_STATE)
#undef TROPHIC_VISIT_STATE
}

}  // namespace trophic
