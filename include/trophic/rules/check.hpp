// SPDX-License-Identifier: MIT
// The requirements on a rule table: each violation is one compile error with a clear message.
#pragma once

#include <trophic/params/policy.hpp>
#include <trophic/population/state.hpp>
#include <trophic/rules/shipped.hpp>
#include <trophic/rules/slots.hpp>

namespace trophic {

template <class Rules>
struct TableParams;

namespace rules {

template <class Policy, class Community = void>
class by_species;

}  // namespace rules

namespace perception::sensors {

template <class Community, class... Lists>
class PerSpeciesOf;

}  // namespace perception::sensors

namespace detail {

/// The policy that a table states for each slot: `stated_<member><Rules>::type`, or the neutral policy of an omitted slot.
#define TROPHIC_STATED(Slot, member, kind, Contract, Neutral, ...) \
  template <class Rules>                                           \
  struct stated_##member {                                         \
    using type = Neutral;                                          \
  };                                                               \
  template <class Rules>                                           \
  requires requires {                                              \
    typename Rules::Slot;                                          \
  }                                                                \
  struct stated_##member<Rules> {                                  \
    using type = typename Rules::Slot;                             \
  };
TROPHIC_RULE_SLOTS(TROPHIC_STATED)
#undef TROPHIC_STATED

/// A policy in a table: if its parameters differ by species, it has the species of the table's community.
template <class Policy, class Rules>
struct in_table {
  using type = Policy;
};
template <class Policy, class Community, class Rules>
struct in_table<rules::by_species<Policy, Community>, Rules> {
  using type = rules::by_species<Policy, typename stated_community<Rules>::type>;
};
template <class... Lists, class Rules>
struct in_table<perception::sensors::PerSpeciesOf<void, Lists...>, Rules> {
  using type = perception::sensors::PerSpeciesOf<typename stated_community<Rules>::type, Lists...>;
};
template <template <class...> class Whole, class... Ps, class Rules>
requires MadeOfParts<Whole<Ps...>>
struct in_table<Whole<Ps...>, Rules> {
  using type = Whole<typename in_table<Ps, Rules>::type...>;
};

/// Returns the slot's first error. Later ones are not checked, so that one mistake gives one error.
enum class Fault {
  none,
  missing,
  by_species,
  part,
  contract,
  name,
  fields,
  open,
  listed,
  twice,
  made,
  made_from_nothing,
  held,
  changing,
  reads,
  reads_traits,
  decides
};

/// Whether each part of a policy satisfies the contract of that part.
template <class Policy>
[[nodiscard]] consteval bool parts_fit() {
  if constexpr (MadeOfParts<Policy>) return Policy::parts_fit;
  return true;
}

template <class Policy, bool fits_contract, bool may_differ_by_species>
[[nodiscard]] consteval Fault fault_of() {
  using Params = ParamsOf<Policy>;
  if constexpr (std::same_as<Policy, NoPolicy>) {
    return Fault::missing;
  } else if constexpr (!may_differ_by_species && !std::same_as<AnswersForSpecies<Policy>, Policy>) {
    return Fault::by_species;
  } else if constexpr (!parts_fit<Policy>()) {
    return Fault::part;
  } else if constexpr (!fits_contract) {
    return Fault::contract;
  } else if constexpr (!Named<Policy>) {
    return Fault::name;
  } else if constexpr (!Parameters<Params>) {
    return Fault::fields;
  } else if constexpr (!OpenParams<Params>) {
    return Fault::open;
  } else if constexpr (!AllListed<members_of<Params>, fields_of<Params>>) {
    return Fault::listed;
  } else if constexpr (!listed_once<Params>()) {
    return Fault::twice;
  } else if constexpr (HasParams<Policy> && !MadeFromParams<Policy>) {
    return Fault::made;
  } else if constexpr (!HasParams<Policy> && !std::default_initializable<Policy>) {
    return Fault::made_from_nothing;
  } else if constexpr (!holds_params_only<Policy>()) {
    return Fault::held;
  } else {
    return params_are_constant<Policy>() ? Fault::none : Fault::changing;
  }
}

/// Whether these acts include all that a policy, or a policy inside it, names in ReadsActs.
template <class Acts, class Policy>
inline constexpr bool has_own_acts_of = true;
template <class Acts, class Policy>
requires requires {
  typename Policy::ReadsActs;
}
inline constexpr bool has_own_acts_of<Acts, Policy> = control::acts::contains_all<Acts, typename Policy::ReadsActs>;
template <class Acts, class Policy>
inline constexpr bool has_acts_of = has_own_acts_of<Acts, Policy>;
template <class Acts, template <class...> class Whole, class... Ps>
inline constexpr bool has_acts_of<Acts, Whole<Ps...>> = has_own_acts_of<Acts, Whole<Ps...>> && (has_acts_of<Acts, Ps> && ...);

/// Whether these traits include all that a policy, or a policy in it, names in ReadsTraits.
template <class Traits, class Policy>
inline constexpr bool has_own_traits_of = true;
template <class Traits, class Policy>
requires requires {
  typename Policy::ReadsTraits;
}
inline constexpr bool has_own_traits_of<Traits, Policy> =
    std::ranges::all_of(std::span<const std::string_view>{Policy::ReadsTraits::trait_names}, [](std::string_view trait) {
      const std::span<const std::string_view> names{Traits::trait_names};
      return std::ranges::find(names, trait) != names.end();
    });
template <class Traits, class Policy>
inline constexpr bool has_traits_of = has_own_traits_of<Traits, Policy>;
template <class Traits, template <class...> class Whole, class... Ps>
inline constexpr bool has_traits_of<Traits, Whole<Ps...>> = has_own_traits_of<Traits, Whole<Ps...>> &&
                                                            (has_traits_of<Traits, Ps> && ...);

/// The error of a policy in a table with these acts and traits; `alone`: its error in any table.
template <class Policy, class Acts, class Traits, Fault alone>
[[nodiscard]] consteval Fault fault_with() {
  if constexpr (alone != Fault::none || !control::ActList<Acts> || !reproduction::TraitRule<Traits>) {
    return alone;
  } else if constexpr (!has_acts_of<Acts, Policy>) {
    return Fault::reads;
  } else if constexpr (!has_traits_of<Traits, Policy>) {
    return Fault::reads_traits;
  } else if constexpr (control::Decides<AnswersForSpecies<Policy>> && !control::EvaluatesOutputs<AnswersForSpecies<Policy>>) {
    return std::same_as<Acts, control::acts::TurnAndTag> ? Fault::none : Fault::decides;
  } else {
    return Fault::none;
  }
}

/// A slot of a table: `type` is its policy, `stated` that policy as written in the table, before in_table.
/// `slot_<member><Rules>` is the same by name.
template <class Rules, RuleSlot slot>
struct policy_in;
#define TROPHIC_SLOT(Slot, member, kind, Contract, Neutral, may_differ_by_species)                                  \
  template <class Rules>                                                                                            \
  struct policy_in<Rules, RuleSlot::member> : in_table<typename stated_##member<Rules>::type, Rules> {              \
    using stated = typename stated_##member<Rules>::type;                                                           \
    using type = typename in_table<stated, Rules>::type;                                                            \
    static constexpr bool is_neutral = std::same_as<type, Neutral>;                                                 \
    static constexpr Fault fault =                                                                                  \
        fault_with<type, typename stated_acts<Rules>::type, AnswersForSpecies<typename stated_traits<Rules>::type>, \
                   fault_of<type, kind::Contract<AnswersForSpecies<type>>, may_differ_by_species>()>();             \
  };                                                                                                                \
  template <class Rules>                                                                                            \
  struct slot_##member : policy_in<Rules, RuleSlot::member> {};
TROPHIC_RULE_SLOTS(TROPHIC_SLOT)
#undef TROPHIC_SLOT

template <class Rules>
concept Final = std::is_final_v<Rules>;

/// Whether a table states its parameters, as a function of its own type.
template <class Rules>
concept StatesParams = requires {
  requires std::same_as<decltype(Rules::params()), TableParams<Rules>>;
};

/// Whether a table is valid.
template <class Rules>
[[nodiscard]] consteval bool has_no_fault() {
  bool none = Final<Rules> && Named<Rules> && StatesParams<Rules>;
  for_each_slot([&]<RuleSlot slot>() { none = none && policy_in<Rules, slot>::fault == Fault::none; });
  return none;
}

/// Fails to compile with one message unless Rules is final, has a name and parameters, and has a policy that satisfies the
/// contract in every slot; slots with a neutral policy may be omitted. The only mistake that cannot be detected here is a
/// misspelt name of such a slot in a table written in full, because C++ does not list the members of a class. with_<slot> and
/// parameters for the slot detect it.
template <class Rules>
struct CheckRules {
  static_assert(Final<Rules>,
                "the rule table must be final, `struct NAME final`: in a table derived from it a misspelt slot would run the "
                "base's rule; to swap a rule use with_<slot>, for other parameters with_params");
  static_assert(Named<Rules>, "the rule table needs static constexpr std::string_view name, for manifests");
  static_assert(
      StatesParams<Rules>,
      "the rule table must state its parameters: static TableParams<TABLE> params() { return TableParams<TABLE>{.slot = "
      "{.number = 1.0}}; }, with its own type for TABLE");

#define TROPHIC_CHECK_SLOT(Slot, member, kind, Contract, ...)                                                                \
  using Slot = typename slot_##member<Rules>::type;                                                                          \
  static constexpr Fault member##_fault = policy_in<Rules, RuleSlot::member>::fault;                                         \
  static_assert(member##_fault != Fault::missing, "the rule table has no slot " #Slot "; write `using " #Slot                \
                                                  " = ...;` or make it from a complete table with with_" #member);           \
  static_assert(member##_fault != Fault::by_species, "Rules::" #Slot                                                         \
                                                     " does not concern a single individual or species, so its policy's "    \
                                                     "parameters cannot differ by_species");                                 \
  static_assert(member##_fault != Fault::part,                                                                               \
                "a part of the policy in Rules::" #Slot " does not fit the contract of that part; see the policy's header"); \
  static_assert(member##_fault != Fault::contract || kind::Contract<AnswersForSpecies<Slot>>,                                \
                "the policy in Rules::" #Slot " needs " TROPHIC_SENTENCE_##Contract);                                        \
  static_assert(member##_fault != Fault::name,                                                                               \
                "the policy in Rules::" #Slot " needs static constexpr std::string_view name, for manifests");               \
  static_assert(member##_fault != Fault::fields,                                                                             \
                "the Params of the policy in Rules::" #Slot                                                                  \
                " need static constexpr auto fields(), listing every parameter; see trophic/params/params.hpp");             \
  static_assert(member##_fault != Fault::open,                                                                               \
                "the Params of the policy in Rules::" #Slot " must be an aggregate: public parameters, no constructor");     \
  static_assert(member##_fault != Fault::listed || AllListed<members_of<ParamsOf<Slot>>, fields_of<ParamsOf<Slot>>>,         \
                "the Params of the policy in Rules::" #Slot                                                                  \
                " must list every parameter in fields(); see trophic/params/params.hpp");                                    \
  static_assert(member##_fault != Fault::twice,                                                                              \
                "the Params of the policy in Rules::" #Slot " must list no parameter and no name twice in fields()");        \
  static_assert(member##_fault != Fault::made,                                                                               \
                "the policy in Rules::" #Slot                                                                                \
                " has Params but cannot be made from them: it needs `Params params;` as its first "                          \
                "member or a constructor from Params");                                                                      \
  static_assert(member##_fault != Fault::made_from_nothing,                                                                  \
                "the policy in Rules::" #Slot " has no Params, so it needs a default constructor");                          \
  static_assert(member##_fault != Fault::held,                                                                               \
                "the policy in Rules::" #Slot                                                                                \
                " has data outside `Params params;`, which no manifest would contain: its parameters are a struct Params "   \
                "in a member params, and what changes is in a State; see trophic/params/policy.hpp");                        \
  static_assert(member##_fault != Fault::changing,                                                                           \
                "the policy in Rules::" #Slot                                                                                \
                " has mutable parameters, which no checkpoint would contain: what changes is in a State; see "               \
                "trophic/population/state.hpp");                                                                             \
  static_assert(member##_fault != Fault::reads,                                                                              \
                "the policy in Rules::" #Slot                                                                                \
                " names an act in ReadsActs that Rules::Acts lacks; see trophic/control/acts/contract.hpp");                 \
  static_assert(member##_fault != Fault::reads_traits,                                                                       \
                "the policy in Rules::" #Slot                                                                                \
                " names a trait in ReadsTraits that Rules::Traits lacks; see trophic/reproduction/traits/contract.hpp");     \
  static_assert(member##_fault != Fault::decides,                                                                            \
                "the policy in Rules::" #Slot                                                                                \
                " has decide, which only turns and chooses a tag, but Rules::Acts has other acts: it needs evaluate; see "   \
                "trophic/control/brain/contract.hpp");
  TROPHIC_RULE_SLOTS(TROPHIC_CHECK_SLOT)
#undef TROPHIC_CHECK_SLOT
};

}  // namespace detail

/// The policy in a slot of a table, or the neutral one of an omitted slot.
template <class Rules, RuleSlot slot>
using PolicyIn = typename detail::policy_in<Rules, slot>::type;

/// Whether a slot of a table holds its neutral policy, so that the table has no such rule.
template <class Rules, RuleSlot slot>
inline constexpr bool is_neutral = detail::policy_in<Rules, slot>::is_neutral;

namespace detail {

template <class Rules>
[[nodiscard]] consteval bool is_table() {
  if constexpr (is_compiled<Rules>)
    return true;
  else
    return has_no_fault<Rules>();
}

}  // namespace detail

/// Whether a type is a rule table: final, with a name and its parameters, and a valid policy in each slot that it states.
/// RuleParams, and therefore every experiment, rejects other types with a message about the error.
template <class Rules>
inline constexpr bool is_rule_table = detail::is_table<Rules>();

namespace detail {

/// Reports the error in an invalid table.
template <class Rules>
[[nodiscard]] consteval bool check_table() {
  if constexpr (!is_rule_table<Rules>) return sizeof(CheckRules<Rules>) > 0;
  return true;
}

}  // namespace detail

}  // namespace trophic
