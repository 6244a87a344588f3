// SPDX-License-Identifier: MIT
// One table with some slots of another, and what the two differ in.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/params/named_params.hpp>
#include <trophic/params/params.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/joined_text.hpp>
#include <type_traits>
#include <vector>

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

/// The slots of these names. A name that is none does not compile.
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

/// Base with the policies and numbers that Other has in the slots of a set; ecology and physics are those of Base.
template <class Base, class Other, SlotSet set>
struct with_rules_of final {
#define TROPHIC_SLOT_OF(Slot, member, kind, Contract) \
  using Slot = typename std::conditional_t<set.contains(#member), Other, Base>::Slot;
  TROPHIC_RULE_SLOTS(TROPHIC_SLOT_OF)
#undef TROPHIC_SLOT_OF

  /// "paper with heredity = shared_copy, mutation = uniform_mutation": policies that differ; numbers are in the manifest.
  struct Words {
    static constexpr auto words = [] {
      std::array<std::string_view, 1 + 4 * slot_names.size()> all;
      std::size_t end = 0;
      all[end++] = Base::name;
#define TROPHIC_NAME_SWAP(Slot, member, kind, Contract)                          \
  if constexpr (!std::same_as<typename Base::Slot, with_rules_of::Slot>) {       \
    all[end] = end == 1 ? " with " : ", ";                                       \
    all[end + 1] = #member;                                                      \
    all[end + 2] = " = ";                                                        \
    all[end + 3] = trophic::detail::policy_name<typename with_rules_of::Slot>(); \
    end += 4;                                                                    \
  }
      TROPHIC_RULE_SLOTS(TROPHIC_NAME_SWAP)
#undef TROPHIC_NAME_SWAP
      return all;
    }();
    static constexpr std::string_view separator{};
  };
  static constexpr std::string_view name = JoinedText<Words>::view;

  static TableParams<with_rules_of> params() {
    const auto base = Base::params();
    const auto other = Other::params();
    TableParams<with_rules_of> own;
#define TROPHIC_PARAMS_OF(Slot, member, kind, Contract) \
  if constexpr (set.contains(#member)) {                \
    own.member = other.member;                          \
  } else {                                              \
    own.member = base.member;                           \
  }
    TROPHIC_RULE_SLOTS(TROPHIC_PARAMS_OF)
#undef TROPHIC_PARAMS_OF
    return own;
  }
  static auto ecology() {
    return Base::ecology();
  }
  static auto physics() {
    return Base::physics();
  }
};

/// One rule or number in which two tables differ.
struct RuleDifference {
  std::string name;  ///< a slot whose policies differ, or the path of a number: "floor.floor", "ecology.arena"
  std::string here;
  std::string there;
  [[nodiscard]] bool is_number() const { return name.find('.') != std::string::npos; }
};

namespace detail {

template <class P>
void append_differences(std::string_view path, const P& here, const P& there, std::vector<RuleDifference>& differences) {
  const NamedParams a = named_params_of(here);
  const NamedParams b = named_params_of(there);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].value != b[i].value) differences.push_back({join_path(path, a[i].path), value_text(a[i]), value_text(b[i])});
  }
}

}  // namespace detail

/// All slots and numbers in which two tables differ, in their order; numbers of policies that differ go with these, and
/// duration is no rule.
template <class Base, class Other>
[[nodiscard]] std::vector<RuleDifference> differences() {
  const RuleParams<Base> here;
  const RuleParams<Other> there;
  std::vector<RuleDifference> all;
#define TROPHIC_DIFFERENCE(Slot, member, kind, Contract)                                     \
  if constexpr (std::same_as<typename Base::Slot, typename Other::Slot>) {                   \
    detail::append_differences(#member, here.member, there.member, all);                     \
  } else {                                                                                   \
    all.push_back({#member, std::string{Base::Slot::name}, std::string{Other::Slot::name}}); \
  }
  TROPHIC_RULE_SLOTS(TROPHIC_DIFFERENCE)
#undef TROPHIC_DIFFERENCE
  auto ecology = Other::ecology();
  ecology.duration_s = Base::ecology().duration_s;
  detail::append_differences("ecology", Base::ecology(), ecology, all);
  detail::append_differences("physics", Base::physics(), Other::physics(), all);
  return all;
}

}  // namespace trophic::rules
