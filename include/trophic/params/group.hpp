// SPDX-License-Identifier: MIT
// Several structs of parameters in one, each under a name: the parameters of a policy that is composed of policies.
#pragma once

#include <cstddef>
#include <trophic/params/params.hpp>

namespace trophic {

namespace detail {

template <std::size_t index, class P>
struct GroupMember {
  P value{};
  friend bool operator==(const GroupMember&, const GroupMember&) = default;
};

}  // namespace detail

/// `Ps...` in order. `Names::names[i]`, a std::string_view, is the name of the i-th, as in "rules.sensors.NAME.full_scale_m".
/// An aggregate: its parameters are listed, checked and set as those of any Params.
template <class Names, class Indices, class... Ps>
struct Group;

template <class Names, std::size_t... indices, class... Ps>
struct Group<Names, std::index_sequence<indices...>, Ps...> : detail::GroupMember<indices, Ps>... {
  template <std::size_t index>
  using Member = std::tuple_element_t<index, std::tuple<Ps...>>;

  template <std::size_t index>
  [[nodiscard]] constexpr Member<index>& get() {
    return static_cast<detail::GroupMember<index, Member<index>>&>(*this).value;
  }
  template <std::size_t index>
  [[nodiscard]] constexpr const Member<index>& get() const {
    return static_cast<const detail::GroupMember<index, Member<index>>&>(*this).value;
  }

  static constexpr auto fields() {
    return std::tuple<Field<Group, Ps>...>{
        field(Names::names[indices], static_cast<Ps Group::*>(&detail::GroupMember<indices, Ps>::value))...};
  }
  friend bool operator==(const Group&, const Group&) = default;
};

template <class Names, class... Ps>
using GroupOf = Group<Names, std::index_sequence_for<Ps...>, Ps...>;

}  // namespace trophic
