// SPDX-License-Identifier: MIT
// The null of a rule table: the same table without inheritance.
#pragma once

#include <concepts>
#include <trophic/backend/contract.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/reproduction/heredity/nothing_inherited.hpp>
#include <trophic/rules/table.hpp>

namespace trophic::rules {

/// The neutral shadow of a table: the same rules and numbers, but every inherited genome is drawn anew. Labels, places and times
/// of birth come about as in the table itself, so a metric that differs between the two shows what inheritance does.
template <class Table>
using neutral_shadow = with_heredity<Table, reproduction::heredity::NothingInherited>;

/// An experiment's shadow: the same seed and numbers.
template <class Table, Backend B>
[[nodiscard]] Experiment<neutral_shadow<Table>, B> shadow_of(const Experiment<Table, B>& experiment) {
  Experiment<neutral_shadow<Table>, B> shadow{.seed = experiment.seed,
                                              .world = experiment.world,
                                              .physics = experiment.physics,
                                              .rules = {},
                                              .backend = experiment.backend};
#define TROPHIC_COPY_NUMBERS(Slot, member, kind, Contract)                                        \
  if constexpr (std::same_as<decltype(shadow.rules.member), decltype(experiment.rules.member)>) { \
    shadow.rules.member = experiment.rules.member;                                                \
  }
  TROPHIC_RULE_SLOTS(TROPHIC_COPY_NUMBERS)
#undef TROPHIC_COPY_NUMBERS
  return shadow;
}

}  // namespace trophic::rules
