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
#define TROPHIC_CHECK_STATE(Slot, member, kind, Contract) \
  using Slot = typename slot_##member<Rules>::type;       \
  TROPHIC_CHECK_STATE_OF(Slot, "the policy in Rules::" #Slot)
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

/// Calls `visit(slot_name, states)` for each slot whose policy has a State that can be saved. Others have been reported above.
template <class Rules, class Visitor>
void for_each_state(const RuleStates<Rules>& states, [[maybe_unused]] Visitor&& visit) {
#define TROPHIC_VISIT_STATE(Slot, member, kind, Contract)                            \
  if constexpr (detail::SavableState<typename detail::slot_##member<Rules>::type>) { \
    visit(std::string_view{#member}, states.member);                                 \
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
