// SPDX-License-Identifier: MIT
// Tables derived from another one: with one rule or sensor swapped, different parameters, a different ecology, or a different
// name.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <trophic/params/policy.hpp>
#include <trophic/rules/check.hpp>
#include <trophic/rules/params.hpp>
#include <trophic/rules/slots.hpp>
#include <trophic/support/joined_text.hpp>
#include <type_traits>

namespace trophic {

namespace detail {

/// An alias for each slot: `Pick<slot>::type`.
template <template <RuleSlot> class Pick>
struct SlotAliases {
#define TROPHIC_ALIAS(Slot, member, ...) using Slot = typename Pick<RuleSlot::member>::type;
  TROPHIC_RULE_SLOTS(TROPHIC_ALIAS)
#undef TROPHIC_ALIAS
};

/// The backends that a table lists as `backends`; empty for a table that runs on any.
template <class Rules>
[[nodiscard]] constexpr auto backends_of() {
  if constexpr (requires { Rules::backends; }) {
    return Rules::backends;
  } else {
    return std::array<std::string_view, 0>{};
  }
}

/// The policies that a table states, and the same with a different one in one slot.
template <class Rules>
struct Stated {
  template <RuleSlot slot>
  using in = std::type_identity<typename policy_in<Rules, slot>::stated>;
};
template <class Rules, RuleSlot swapped, class Policy>
struct Swapped {
  template <RuleSlot slot>
  using in = std::conditional_t<slot == swapped, std::type_identity<Policy>, typename Stated<Rules>::template in<slot>>;
};

/// The members that a derived table takes over unchanged.
template <class Rules>
struct OfTable : SlotAliases<Stated<Rules>::template in> {
  static constexpr auto backends = backends_of<Rules>();
  static auto ecology() { return Rules::ecology(); }
  static auto physics() { return Rules::physics(); }
};

/// The parameters of one table for another one with the same policies.
template <class Table, class Rules>
[[nodiscard]] TableParams<Table> same_params(const TableParams<Rules>& from) {
  TableParams<Table> own;
  for_each_slot([&]<RuleSlot slot>() { of_slot<slot>(own) = of_slot<slot>(from); });
  return own;
}

}  // namespace detail

/// A table with the rule of one slot swapped, with the policy's own parameters. Written with_<slot><Rules, Policy>.
template <class Rules, RuleSlot swapped, class Policy>
struct with_rule final : detail::SlotAliases<detail::Swapped<Rules, swapped, Policy>::template in> {
  /// "paper with mutation = uniform_mutation".
  struct Words {
    static constexpr std::array<std::string_view, 5> words{detail::policy_name<Rules>(), " with ", slot_name(swapped), " = ",
                                                           detail::policy_name<Policy>()};
    static constexpr std::string_view separator{};
  };
  static constexpr std::string_view name = JoinedText<Words>::view;
  static constexpr auto backends = detail::backends_of<Rules>();

  static TableParams<with_rule> params() {
    const auto kept = detail::stated_params<Rules>();
    TableParams<with_rule> own;
    for_each_slot([&]<RuleSlot slot>() {
      constexpr bool is_kept = slot != swapped && std::same_as<PolicyIn<with_rule, slot>, PolicyIn<Rules, slot>>;
      if constexpr (is_kept) of_slot<slot>(own) = of_slot<slot>(kept);
    });
    return own;
  }
  static auto ecology() { return Rules::ecology(); }
  static auto physics() { return Rules::physics(); }
};

// with_<slot><Rules, Policy>: the table with one rule swapped. Swaps nest.
#define TROPHIC_WITH(Slot, member, ...) \
  template <class Rules, class Policy>  \
  using with_##member = with_rule<Rules, RuleSlot::member, Policy>;
TROPHIC_RULE_SLOTS(TROPHIC_WITH)
#undef TROPHIC_WITH

// A kind of rules is not a slot, so with_death does not compile.
#define TROPHIC_NO_SLOT(kind, slots)                                                                                \
  namespace detail {                                                                                                \
  template <class Rules>                                                                                            \
  struct kind##_is_no_slot {                                                                                        \
    static_assert(std::is_void_v<Rules>, #kind " is a kind of rules, not a slot; its slots are swapped by " slots); \
    using type = Rules;                                                                                             \
  };                                                                                                                \
  }                                                                                                                 \
  template <class Rules, class Policy>                                                                              \
  using with_##kind = typename detail::kind##_is_no_slot<Rules>::type;
TROPHIC_NO_SLOT(initialization, "with_community, with_placement and with_embodiment")
TROPHIC_NO_SLOT(perception, "with_heading, with_visibility, with_sensors, with_newborn_tag and with_tag_switch")
TROPHIC_NO_SLOT(control, "with_acts, with_brain, with_pace, with_steering and with_gait")
TROPHIC_NO_SLOT(
    reproduction,
    "with_initial_genome, with_genome_source, with_parent, with_heredity, with_mutation, with_body_plan, with_viability, "
    "with_traits and with_recruitment")
TROPHIC_NO_SLOT(death, "with_activation, with_capture, with_floor, with_starvation, with_minimum_predators and with_senescence")
#undef TROPHIC_NO_SLOT

/// A table with different parameters: `with_params<Paper, [](auto& params) { params.floor.floor = 5; }>`. It keeps its name, as
/// does a table whose parameters are set at run time; a manifest lists them.
template <class Rules, auto change>
struct with_params final : detail::OfTable<Rules> {
  static constexpr std::string_view name = detail::policy_name<Rules>();
  static TableParams<with_params> params() {
    TableParams<Rules> changed = detail::stated_params<Rules>();
    change(changed);
    return detail::same_params<with_params>(changed);
  }
};

/// A table in a different ecology: `with_ecology<Paper, [](auto& ecology) { ecology.robots = 60; }>`. It also keeps its name.
template <class Rules, auto change>
struct with_ecology final : detail::OfTable<Rules> {
  static constexpr std::string_view name = detail::policy_name<Rules>();
  static TableParams<with_ecology> params() { return detail::same_params<with_ecology>(detail::stated_params<Rules>()); }
  static auto ecology() {
    auto changed = Rules::ecology();
    change(changed);
    return changed;
  }
};

/// The name of a table as a template argument.
template <std::size_t size>
struct TableName {
  char text[size]{};
  consteval TableName(const char (&from)[size]) { std::copy_n(from, size, text); }
};

/// A table under a different name: `named<with_senescence<Paper, OldAge>, "ageing">`.
template <class Rules, TableName own_name>
struct named final : detail::OfTable<Rules> {
  static constexpr std::string_view name{own_name.text};
  static TableParams<named> params() { return detail::same_params<named>(detail::stated_params<Rules>()); }
};

namespace rules {

namespace detail {

template <class Sensors, class Old, class New>
struct swap_sensor {
  static_assert(Sensors::template contains<Old>, "with_sensor: the table's Sensors have no such sensor to swap");
  using type = typename Sensors::template Replaced<Old, New>;
};

}  // namespace detail

/// A table with the sensor New instead of Old, and the parameters of its sensors at their defaults.
template <class Table, class Old, class New>
using with_sensor = with_sensors<Table, typename detail::swap_sensor<typename Table::Sensors, Old, New>::type>;

}  // namespace rules

}  // namespace trophic
