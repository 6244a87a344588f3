// SPDX-License-Identifier: MIT
// The policies of a rule table as objects.
#pragma once

#include <cstddef>
#include <string>
#include <trophic/params/policy.hpp>
#include <trophic/rules/check.hpp>
#include <trophic/rules/params.hpp>
#include <trophic/rules/slot_rule.hpp>
#include <trophic/rules/slots.hpp>
#include <trophic/rules/with.hpp>
#include <utility>
#include <vector>

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

namespace rules {

/// The rules of a table, in the order of slots. A slot with its neutral policy is omitted.
template <class Rules>
[[nodiscard]] std::vector<SlotRule> slot_rules() {
  std::vector<SlotRule> all;
  for_each_slot([&]<RuleSlot slot>() {
    using Policy = PolicyIn<Rules, slot>;
    if (is_neutral<Rules, slot>) return;
    all.push_back({slot_kind(slot), slot_name(slot), trophic::detail::policy_name<Policy>(), source_of<Policy>()});
  });
  return all;
}

}  // namespace rules

/// The name of a rule table: its own, with its swapped rules: "paper with mutation = uniform_mutation".
template <class Rules>
[[nodiscard]] std::string table_name() {
  return std::string{detail::policy_name<Rules>()};
}

}  // namespace trophic
