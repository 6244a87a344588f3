// SPDX-License-Identifier: MIT
// The policies of a rule table as objects.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <trophic/params/policy.hpp>
#include <trophic/rules/check.hpp>
#include <trophic/rules/params.hpp>
#include <trophic/rules/slots.hpp>
#include <trophic/rules/with.hpp>
#include <utility>

namespace trophic {

/// One object of each policy of a rule table.
template <class Rules>
struct Policies {
#define TROPHIC_POLICY(Slot, member, ...) typename detail::slot_##member<Rules>::type member;
  TROPHIC_RULE_SLOTS(TROPHIC_POLICY)
#undef TROPHIC_POLICY
};

template <class Rules>
[[nodiscard]] Policies<Rules> make_policies(const RuleParams<Rules>& params) {
  return [&]<std::size_t... slot>(std::index_sequence<slot...>) {
    return Policies<Rules>{make_policy<PolicyIn<Rules, static_cast<RuleSlot>(slot)>>(of_slot<static_cast<RuleSlot>(slot)>(params),
                                                                                     slot_name(static_cast<RuleSlot>(slot)))...};
  }
  (std::make_index_sequence<rules::slot_names.size()>{});
}

/// Calls `visit(slot_name, policy_name)` for each slot with a policy other than its neutral one.
template <class Rules, class Visitor>
void for_each_rule(Visitor&& visit) {
  for_each_slot([&]<RuleSlot slot>() {
    if constexpr (!is_neutral<Rules, slot>) visit(slot_name(slot), detail::policy_name<PolicyIn<Rules, slot>>());
  });
}

/// The name of a rule table: its own, with its swapped rules: "paper with mutation = uniform_mutation".
template <class Rules>
[[nodiscard]] std::string table_name() {
  return std::string{detail::policy_name<Rules>()};
}

}  // namespace trophic
