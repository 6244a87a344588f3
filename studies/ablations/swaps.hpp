// SPDX-License-Identifier: MIT
// A table with some slots as another table states them, and the tables that each direction offers.
#pragma once

#include <string>
#include <trophic/experiment/table_experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/rules/with_part.hpp>
#include <utility>
#include <vector>

namespace trophic::ablations {

using rules::Paper;
using rules::Released;

/// Sets the parameters of a slot as a table states them.
template <class Table, RuleSlot slot>
struct Stated {
  constexpr void operator()(auto& params) const {
    const auto stated = Table::params();
    of_slot<slot>(params) = of_slot<slot>(stated);
  }
};

template <class Base, class Other, RuleSlot... slots>
struct Swapped {
  using type = Base;
};
template <class Base, class Other, RuleSlot slot, RuleSlot... more>
struct Swapped<Base, Other, slot, more...>
    : Swapped<with_params<with_rule<Base, slot, PolicyIn<Other, slot>>, Stated<Other, slot>{}>, Other, more...> {};

/// The table Base with the policies and parameters of Other in these slots.
template <class Base, class Other, RuleSlot... slots>
using with_slots_of = typename Swapped<Base, Other, slots...>::type;

using Tables = std::vector<std::pair<std::string, MakeExperiment>>;

/// `paper` with each rule of `released`, and `released` with each rule of `paper`: from_paper.cpp and from_released.cpp, as all
/// of them in one file take much memory to compile.
[[nodiscard]] Tables from_paper();
[[nodiscard]] Tables from_released();

}  // namespace trophic::ablations
