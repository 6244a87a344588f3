// SPDX-License-Identifier: MIT
// What a table of rules is: one policy per slot, and its numbers. Swap one rule with with_<slot>.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <trophic/params/params.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/rules/slots.hpp>
#include <tuple>
#include <type_traits>

namespace trophic {

/// The name of a rule table: its own, and what was swapped in it: "paper with mutation = uniform_mutation".
template <class Rules>
[[nodiscard]] std::string table_name() {
  if constexpr (requires { Rules::swapped_name(); }) {
    return Rules::swapped_name();
  } else {
    return std::string{Rules::name};
  }
}

namespace detail {

/// Stands for the policy of a slot that a table lacks.
struct NoPolicy {};

/// `slot_<member><Rules>::type`: the policy in a slot.
#define TROPHIC_SLOT(Slot, member, kind, Contract) \
  template <class Rules>                           \
  struct slot_##member {                           \
    using type = NoPolicy;                         \
  };                                               \
  template <class Rules>                           \
  requires requires {                              \
    typename Rules::Slot;                          \
  }                                                \
  struct slot_##member<Rules> {                    \
    using type = typename Rules::Slot;             \
  };
TROPHIC_RULE_SLOTS(TROPHIC_SLOT)
#undef TROPHIC_SLOT

/// Fails to compile, with one sentence, unless Rules has a policy in every slot that fits the slot's contract.
template <class Rules>
struct CheckRules {
#define TROPHIC_CHECK_SLOT(Slot, member, kind, Contract)                                                              \
  using Slot = typename slot_##member<Rules>::type;                                                                   \
  static_assert(!std::same_as<Slot, NoPolicy>, "the rule table has no slot " #Slot "; write `using " #Slot            \
                                               " = ...;` or derive it from a complete table with with_" #member);     \
  static_assert(kind::Contract<Slot> || std::same_as<Slot, NoPolicy>,                                                 \
                "the policy in Rules::" #Slot " needs " TROPHIC_SENTENCE_##Contract);                                 \
  static_assert(Named<Slot> || std::same_as<Slot, NoPolicy>,                                                          \
                "the policy in Rules::" #Slot " needs static constexpr std::string_view name, for manifests");        \
  static_assert(Parameters<ParamsOf<Slot>>,                                                                           \
                "the Params of the policy in Rules::" #Slot                                                           \
                " need static constexpr auto fields(), listing every number; see trophic/params/params.hpp");         \
  static_assert(OpenParams<ParamsOf<Slot>>,                                                                           \
                "the Params of the policy in Rules::" #Slot " must be an aggregate: public numbers, no constructor"); \
  static_assert(AllListed<members_of<ParamsOf<Slot>>, fields_of<ParamsOf<Slot>>>,                                     \
                "the Params of the policy in Rules::" #Slot                                                           \
                " must list every number in fields(); see trophic/params/params.hpp");                                \
  static_assert(listed_once<ParamsOf<Slot>>(),                                                                        \
                "the Params of the policy in Rules::" #Slot " must list no number and no name twice in fields()");    \
  static_assert(!HasNumbers<Slot> || MadeFromParams<Slot>,                                                            \
                "the policy in Rules::" #Slot                                                                         \
                " has Params but cannot be made from them: it needs `Params params;` as its first "                   \
                "member or a constructor from Params");                                                               \
  static_assert(HasNumbers<Slot> || std::default_initializable<Slot>,                                                 \
                "the policy in Rules::" #Slot " has no Params, so it needs a default constructor");
  TROPHIC_RULE_SLOTS(TROPHIC_CHECK_SLOT)
#undef TROPHIC_CHECK_SLOT
  static constexpr bool ok = true;
};

/// A tuple of all arguments but the first, which lets a list begin with a comma.
template <class... Items>
[[nodiscard]] constexpr std::tuple<Items...> tuple_after(int, Items... items) {
  return {items...};
}

}  // namespace detail

/// The numbers of a rule table, one member per slot, each starting at the table's own number where it states one
/// (`static constexpr TagCoolDown::Params tag_switch{...}` beside `using TagSwitch = ...`) and at the policy's default elsewhere.
template <class Rules>
struct RuleNumbers {
  static_assert(detail::CheckRules<Rules>::ok);
#define TROPHIC_NUMBERS(Slot, member, kind, Contract)                 \
  ParamsOf<typename detail::slot_##member<Rules>::type> member = [] { \
    if constexpr (requires { Rules::member; })                        \
      return Rules::member;                                           \
    else                                                              \
      return ParamsOf<typename detail::slot_##member<Rules>::type>{}; \
  }();
  TROPHIC_RULE_SLOTS(TROPHIC_NUMBERS)
#undef TROPHIC_NUMBERS

  static constexpr auto fields() {
#define TROPHIC_FIELD(Slot, member, kind, Contract) , field(#member, &RuleNumbers::member)
    return detail::tuple_after(0 TROPHIC_RULE_SLOTS(TROPHIC_FIELD));
#undef TROPHIC_FIELD
  }
};

/// One object of each policy of a rule table, ready to be asked.
template <class Rules>
struct Policies {
#define TROPHIC_POLICY(Slot, member, kind, Contract) typename detail::slot_##member<Rules>::type member;
  TROPHIC_RULE_SLOTS(TROPHIC_POLICY)
#undef TROPHIC_POLICY
};

template <class Rules>
[[nodiscard]] Policies<Rules> make_policies(const RuleNumbers<Rules>& numbers) {
  return {
#define TROPHIC_MAKE_POLICY(Slot, member, kind, Contract) \
  .member = make_policy<typename detail::slot_##member<Rules>::type>(numbers.member, #member),
      TROPHIC_RULE_SLOTS(TROPHIC_MAKE_POLICY)
#undef TROPHIC_MAKE_POLICY
  };
}

/// Calls `visit(slot_name, policy_name)` for each slot.
template <class Rules, class Visitor>
void for_each_rule(Visitor&& visit) {
#define TROPHIC_VISIT(Slot, member, kind, Contract) \
  visit(std::string_view{#member}, detail::policy_name<typename detail::slot_##member<Rules>::type>());
  TROPHIC_RULE_SLOTS(TROPHIC_VISIT)
#undef TROPHIC_VISIT
}

// with_<slot><Table, Policy>: the table with one rule swapped, that rule's numbers at the policy's own defaults.
#define TROPHIC_WITH(Slot, member, kind, Contract)                                                     \
  template <class Rules, class Policy>                                                                 \
  struct with_##member : Rules {                                                                       \
    using Slot = Policy;                                                                               \
    inline static const ParamsOf<Policy> member{};                                                     \
    static std::string swapped_name() {                                                                \
      return table_name<Rules>().append(" with " #member " = ").append(detail::policy_name<Policy>()); \
    }                                                                                                  \
  };
TROPHIC_RULE_SLOTS(TROPHIC_WITH)
#undef TROPHIC_WITH

}  // namespace trophic
