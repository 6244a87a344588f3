// SPDX-License-Identifier: MIT
// The number of members of an aggregate, at compile time.
#pragma once

#include <cstddef>
#include <exception>
#include <trophic/support/cpp20.hpp>
#include <type_traits>
#include <utility>

namespace trophic::detail {

/// Converts to the type of any member. Named in unevaluated initialisers, never constructed. Some compilers require the
/// definition for types without linkage.
struct AnyMember {
  template <class T>
  operator T() const noexcept {
    std::terminate();
  }
};

template <class Aggregate, std::size_t... I>
[[nodiscard]] consteval bool takes(std::index_sequence<I...>) {
  return requires {
    Aggregate{(static_cast<void>(I), AnyMember{})...};
  };
}

/// Whether `{}` may initialise one member between the given numbers of initialisers.
template <class Aggregate, std::size_t... Before, std::size_t... After>
[[nodiscard]] consteval bool takes_around(std::index_sequence<Before...>, std::index_sequence<After...>) {
  return requires {
    Aggregate{(static_cast<void>(Before), AnyMember{})..., {}, (static_cast<void>(After), AnyMember{})...};
  };
}

/// The largest number of initialisers of an aggregate: one for each member, but one for each element of an array.
template <class Aggregate, std::size_t tried = 0>
[[nodiscard]] consteval std::size_t initialisers() {
  if constexpr (takes<Aggregate>(std::make_index_sequence<tried + 1>{})) {
    return initialisers<Aggregate, tried + 1>();
  } else {
    return tried;
  }
}

template <class Aggregate, std::size_t before, std::size_t tried = 0>
[[nodiscard]] consteval std::size_t initialisers_after() {
  if constexpr (takes_around<Aggregate>(std::make_index_sequence<before>{}, std::make_index_sequence<tried + 1>{})) {
    return initialisers_after<Aggregate, before, tried + 1>();
  } else {
    return tried;
  }
}

/// The number of members of an aggregate. `{}` initialises a whole array, so the initialisers that can follow it show where the
/// next member begins. A base counts as one member. Each member must be default-constructible and copyable.
template <class Aggregate, std::size_t initialiser = 0>
requires std::is_aggregate_v<Aggregate>
[[nodiscard]] consteval std::size_t member_count() {
  constexpr std::size_t all = initialisers<Aggregate>();
  if constexpr (initialiser >= all) {
    return 0;
  } else {
    return 1 + member_count<Aggregate, all - initialisers_after<Aggregate, initialiser>()>();
  }
}

}  // namespace trophic::detail
