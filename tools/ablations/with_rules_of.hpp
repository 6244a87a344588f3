// SPDX-License-Identifier: MIT
// Combines slots of two tables, and lists their differences.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <trophic/params/named_params.hpp>
#include <trophic/population/parts.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/rules/with_part.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::rules {

/// Some slots of a rule table.
struct SlotSet {
  std::uint64_t mask = 0;  ///< bit i: slot_names[i]

  [[nodiscard]] constexpr bool contains(std::string_view slot) const {
    for (std::size_t i = 0; i < slot_names.size(); ++i) {
      if (slot_names[i] == slot) return (mask >> i & 1U) != 0;
    }
    throw std::invalid_argument{"no slot of a rule table has this name"};
  }
  friend constexpr bool operator==(SlotSet, SlotSet) = default;
};
static_assert(slot_names.size() <= 64);

/// The slots with these names. An unknown name does not compile.
[[nodiscard]] consteval SlotSet slots(std::initializer_list<std::string_view> names) {
  SlotSet set;
  for (const std::string_view name : names) {
    if (set.contains(name)) throw std::invalid_argument{"a slot is named twice"};
    for (std::size_t i = 0; i < slot_names.size(); ++i) {
      if (slot_names[i] == name) set.mask |= std::uint64_t{1} << i;
    }
  }
  return set;
}

namespace detail {

template <class Base, class Other, SlotSet set>
struct SlotsOf {
  template <RuleSlot slot>
  using in = typename trophic::detail::Stated<std::conditional_t<set.contains(slot_name(slot)), Other, Base>>::template in<slot>;
};

}  // namespace detail

/// Base with the policies and parameters of Other in the slots of a set; ecology and physics are those of Base.
template <class Base, class Other, SlotSet set>
struct with_rules_of final : trophic::detail::SlotAliases<detail::SlotsOf<Base, Other, set>::template in> {
  /// "paper with heredity = shared_copy, mutation = uniform_mutation": policies that differ; parameters are in the manifest.
  struct Words {
    static constexpr auto words = [] {
      std::array<std::string_view, 1 + 4 * slot_names.size()> all;
      std::size_t end = 0;
      all[end++] = Base::name;
      for_each_slot([&]<RuleSlot slot>() {
        if constexpr (!std::same_as<PolicyIn<Base, slot>, PolicyIn<with_rules_of, slot>>) {
          all[end] = end == 1 ? " with " : ", ";
          all[end + 1] = slot_name(slot);
          all[end + 2] = " = ";
          all[end + 3] = trophic::detail::policy_name<PolicyIn<with_rules_of, slot>>();
          end += 4;
        }
      });
      return all;
    }();
    static constexpr std::string_view separator{};
  };
  static constexpr std::string_view name = JoinedText<Words>::view;

  static TableParams<with_rules_of> params() {
    const auto base = Base::params();
    const auto other = Other::params();
    TableParams<with_rules_of> own;
    for_each_slot([&]<RuleSlot slot>() {
      if constexpr (set.contains(slot_name(slot))) {
        of_slot<slot>(own) = of_slot<slot>(other);
      } else {
        of_slot<slot>(own) = of_slot<slot>(base);
      }
    });
    return own;
  }
  static auto ecology() { return Base::ecology(); }
  static auto physics() { return Base::physics(); }
};

/// Base with one part of a policy, and its parameters, from Other.
template <class Base, class Other, RuleSlot slot, std::size_t place>
struct with_part_of final
    : trophic::detail::OfTable<with_part<Base, slot, place, typename PolicyIn<Other, slot>::template Part<place>>> {
  using Swapped = with_part<Base, slot, place, typename PolicyIn<Other, slot>::template Part<place>>;
  static constexpr std::string_view name = Swapped::name;
  static TableParams<with_part_of> params() {
    auto own = trophic::detail::same_params<with_part_of>(Swapped::params());
    const auto other = Other::params();
    trophic::detail::part_of<place>(of_slot<slot>(own)) = trophic::detail::part_of<place>(of_slot<slot>(other));
    return own;
  }
};

/// One rule or number in which two tables differ.
struct RuleDifference {
  std::string name;  ///< a slot whose policies differ, a part of one ("parent.starved"), or the path of a number ("floor.floor")
  std::string here;
  std::string there;
  bool is_number = false;
};

namespace detail {

template <class P>
void append_differences(std::string_view path, const P& here, const P& there, std::vector<RuleDifference>& differences) {
  const NamedParams a = named_params_of(here);
  const NamedParams b = named_params_of(there);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].value != b[i].value) differences.push_back({join_path(path, a[i].path), value_text(a[i]), value_text(b[i]), true});
  }
}

/// Whether two policies have the same parts, each with any policy.
template <class Here, class There>
inline constexpr bool alike_in_parts = false;
template <template <class...> class Whole, class... Here, class... There>
requires MadeOfParts<Whole<Here...>> && MadeOfParts<Whole<There...>>
inline constexpr bool alike_in_parts<Whole<Here...>, Whole<There...>> = true;

/// The differences between two policies of one slot, or between their parts.
template <class Here, class There, class ParamsHere, class ParamsThere>
void append_policy_differences(const std::string& path, const ParamsHere& here, const ParamsThere& there,
                               std::vector<RuleDifference>& differences) {
  if constexpr (std::same_as<Here, There>) {
    append_differences(path, here, there, differences);
  } else if constexpr (alike_in_parts<Here, There>) {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      (append_policy_differences<typename Here::template Part<place>, typename There::template Part<place>>(
           join_path(path, Here::part_names[place]), trophic::detail::part_of<place>(here),
           trophic::detail::part_of<place>(there), differences),
       ...);
    }
    (std::make_index_sequence<Here::part_count>{});
  } else {
    differences.push_back({path, std::string{Here::name}, std::string{There::name}, false});
  }
}

}  // namespace detail

/// All slots, parts and parameters in which two tables differ, in order. Parameters of policies that differ are omitted, as is
/// the duration, which is not a rule.
template <class Base, class Other>
[[nodiscard]] std::vector<RuleDifference> differences() {
  const RuleParams<Base> here;
  const RuleParams<Other> there;
  std::vector<RuleDifference> all;
  for_each_slot([&]<RuleSlot slot>() {
    detail::append_policy_differences<PolicyIn<Base, slot>, PolicyIn<Other, slot>>(
        std::string{slot_name(slot)}, of_slot<slot>(here), of_slot<slot>(there), all);
  });
  auto ecology = Other::ecology();
  ecology.duration_s = Base::ecology().duration_s;
  detail::append_differences("ecology", Base::ecology(), ecology, all);
  detail::append_differences("physics", Base::physics(), Other::physics(), all);
  return all;
}

}  // namespace trophic::rules
