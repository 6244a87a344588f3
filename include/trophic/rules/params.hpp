// SPDX-License-Identifier: MIT
// The parameters of a rule table: those that it states, and those with which an experiment runs.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/rules/check.hpp>
#include <trophic/rules/slots.hpp>

namespace trophic {

/// The parameters that a table states: one member per slot, each a policy's Params with the policy's own defaults. A table
/// initialises it by designated initialisers, so that a misspelt slot or number does not compile: `static TableParams<Mine>
/// params() { return TableParams<Mine>{.tag_switch = {.cool_down_s = 20.0}}; }`.
template <class Rules>
struct TableParams {
#define TROPHIC_NUMBERS(Slot, member, ...) ParamsOf<typename detail::slot_##member<Rules>::type> member{};
  TROPHIC_RULE_SLOTS(TROPHIC_NUMBERS)
#undef TROPHIC_NUMBERS
};

namespace detail {

/// The parameters of a table, or the policies' defaults for a table that states none, which `CheckRules` rejects.
template <class Rules>
[[nodiscard]] TableParams<Rules> stated_params() {
  if constexpr (StatesParams<Rules>) return Rules::params();
  return {};
}

}  // namespace detail

/// The parameters of an experiment's rules, one member per slot. Each defaults to the table's parameter.
template <class Rules>
struct RuleParams {
  static_assert(detail::check_table<Rules>());
#define TROPHIC_NUMBERS(Slot, member, ...) \
  ParamsOf<typename detail::slot_##member<Rules>::type> member = detail::stated_params<Rules>().member;
  TROPHIC_RULE_SLOTS(TROPHIC_NUMBERS)
#undef TROPHIC_NUMBERS

  template <class Self, class Visitor>
  static constexpr void visit_fields(Self& params, Visitor&& visit) {
    for_each_slot([&]<RuleSlot slot>() { visit(FieldText{slot_name(slot), {}, {}, slot_read(slot)}, of_slot<slot>(params)); });
  }
};

}  // namespace trophic
