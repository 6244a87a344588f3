// SPDX-License-Identifier: MIT
// A table with one part of a policy swapped: the parent rule for one cause, the interval between starvation procedures.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/parts.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic {

namespace detail {

template <class Whole, std::size_t swapped, class Policy, class Indices>
struct whole_with_part;
template <template <class...> class Whole, class... Ps, std::size_t swapped, class Policy, std::size_t... place>
struct whole_with_part<Whole<Ps...>, swapped, Policy, std::index_sequence<place...>> {
  using type = Whole<std::conditional_t<place == swapped, Policy, Ps>...>;
};

/// `part_of(params)`: the parameters of one part.
template <std::size_t place, class Params>
[[nodiscard]] constexpr auto& part_of(Params& params) {
  return params.*(std::get<place>(std::remove_const_t<Params>::fields()).member);
}

template <class Rules, RuleSlot slot, std::size_t place, class Policy>
using WithWhole = with_rule<Rules, slot,
                            typename whole_with_part<PolicyIn<Rules, slot>, place, Policy,
                                                     std::make_index_sequence<PolicyIn<Rules, slot>::part_count>>::type>;

template <class Rules, RuleSlot slot, std::size_t place, class Policy>
struct with_one_part final : OfTable<WithWhole<Rules, slot, place, Policy>> {
  /// "paper with parent.starved = nearest_victim".
  struct Words {
    static constexpr std::array<std::string_view, 7> words{
        policy_name<Rules>(), " with ", slot_name(slot), ".", PolicyIn<Rules, slot>::part_names[place], " = ",
        policy_name<Policy>()};
    static constexpr std::string_view separator{};
  };
  static constexpr std::string_view name = JoinedText<Words>::view;

  static TableParams<with_one_part> params() {
    auto own = same_params<with_one_part>(stated_params<WithWhole<Rules, slot, place, Policy>>());
    const auto kept = stated_params<Rules>();
    [&]<std::size_t... other>(std::index_sequence<other...>) {
      const auto keep = [&]<std::size_t one>() {
        if constexpr (one != place) part_of<one>(of_slot<slot>(own)) = part_of<one>(of_slot<slot>(kept));
      };
      (keep.template operator()<other>(), ...);
    }
    (std::make_index_sequence<PolicyIn<Rules, slot>::part_count>{});
    return own;
  }
};

template <class Rules, RuleSlot slot, std::size_t place, class Policy>
struct swap_part {
  static_assert(MadeOfParts<PolicyIn<Rules, slot>>,
                "with_part: the table's policy in this slot is not made of parts; swap it by with_<slot>");
  using type = Rules;
};
template <class Rules, RuleSlot slot, std::size_t place, class Policy>
requires MadeOfParts<PolicyIn<Rules, slot>>
struct swap_part<Rules, slot, place, Policy> {
  using type = with_one_part<Rules, slot, place, Policy>;
};

}  // namespace detail

/// A table with one part of a policy swapped, with the new part's own parameters; the other parts keep the table's parameters.
template <class Rules, RuleSlot slot, std::size_t place, class Policy>
using with_part = typename detail::swap_part<Rules, slot, place, Policy>::type;

/// The table with a different parent rule after deaths from this cause: `with_parent_after<Paper, Cause::starved,
/// NearestVictim>`. Its Parent must be a ByCause.
template <class Rules, Cause cause, class Policy>
using with_parent_after = with_part<Rules, RuleSlot::parent, static_cast<std::size_t>(cause), Policy>;

/// The table with a different rule for the interval between starvation procedures, the exemption, or the choice of victims. Its
/// Starvation must be a Procedure.
template <class Rules, class Policy>
using with_starvation_interval = with_part<Rules, RuleSlot::starvation, 0, Policy>;
template <class Rules, class Policy>
using with_starvation_exemption = with_part<Rules, RuleSlot::starvation, 1, Policy>;
template <class Rules, class Policy>
using with_starvation_choice = with_part<Rules, RuleSlot::starvation, 2, Policy>;

}  // namespace trophic
