// SPDX-License-Identifier: MIT
// The states of all rules of a table.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

namespace detail {

/// Fails to compile with one message if the State of a part of a policy violates population/state.hpp.
template <class Part>
struct CheckPartState {
  TROPHIC_CHECK_STATE_OF(AnswersForSpecies<Part>, "a part of a policy")
  static constexpr bool ok = true;
};
template <template <class...> class Whole, class... Ps>
requires MadeOfParts<Whole<Ps...>>
struct CheckPartState<Whole<Ps...>> {
  static constexpr bool ok = (CheckPartState<Ps>::ok && ...);
};

template <class P>
[[nodiscard]] consteval bool parts_are_checked() {
  if constexpr (MadeOfParts<P>) return CheckPartState<P>::ok;
  return true;
}

/// Fails to compile with one message if a policy with a State violates population/state.hpp.
template <class Rules>
struct CheckStates {
#define TROPHIC_CHECK_STATE(Slot, member, ...)                         \
  using Slot = AnswersForSpecies<typename slot_##member<Rules>::type>; \
  TROPHIC_CHECK_STATE_OF(Slot, "the policy in Rules::" #Slot)          \
  static_assert(parts_are_checked<Slot>());
  TROPHIC_RULE_SLOTS(TROPHIC_CHECK_STATE)
#undef TROPHIC_CHECK_STATE
  static constexpr bool ok = true;
};

/// Calls `visit(policy, states)` for a policy or for each of its parts.
template <class P, class States, class Visitor>
void visit_with_parts(const P& policy, States& states, const Visitor& visit) {
  if constexpr (MadeOfParts<P>) {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      (visit_with_parts(policy.template part<place>(), states.template part<place>(), visit), ...);
    }
    (std::make_index_sequence<P::part_count>{});
  } else {
    visit(policy, states);
  }
}

/// Calls `visit(path, states)` for the states of a policy, or of each of its parts: "SLOT" or "SLOT.PART".
template <class P, class Visitor>
void visit_named_states(const std::string& path, const BodyStates<P>& states, const Visitor& visit) {
  if constexpr (MadeOfParts<P>) {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      (visit_named_states(join_path(path, P::part_names[place]), states.template part<place>(), visit), ...);
    }
    (std::make_index_sequence<P::part_count>{});
  } else if constexpr (SavableState<P>) {
    visit(std::string_view{path}, states);
  }
}

}  // namespace detail

/// The states of all rules of a table, one member per slot. Only the population writes them.
template <class Rules>
struct RuleStates {
  static_assert(detail::CheckStates<Rules>::ok);
#define TROPHIC_STATES(Slot, member, ...) [[no_unique_address]] BodyStates<typename detail::slot_##member<Rules>::type> member;
  TROPHIC_RULE_SLOTS(TROPHIC_STATES)
#undef TROPHIC_STATES
};

/// Calls `visit(path, states)` for each State of a table that can be saved; `path` is SLOT, or SLOT.PART for a part of a policy.
/// States that cannot be saved have been reported above.
template <class Rules, class Visitor>
void for_each_state(const RuleStates<Rules>& states, const Visitor& visit) {
  for_each_slot([&]<RuleSlot slot>() {
    detail::visit_named_states<PolicyIn<Rules, slot>>(std::string{slot_name(slot)}, of_slot<slot>(states), visit);
  });
}

/// Calls `visit(policy, states)` for each policy, or part of one, that has a State. One that lacks `born` has been reported
/// above.
template <class Rules, class Visitor>
void for_each_state(const Policies<Rules>& rules, RuleStates<Rules>& states, const Visitor& visit) {
  for_each_slot([&]<RuleSlot slot>() {
    detail::visit_with_parts(of_slot<slot>(rules), of_slot<slot>(states), [&]<class P>(const P& policy, BodyStates<P>& own) {
      if constexpr (detail::BornWithState<P>) visit(policy, own);
    });
  });
}

}  // namespace trophic
