// SPDX-License-Identifier: MIT
// An experiment without inheritance.
#pragma once

#include <concepts>
#include <trophic/backend/contract.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/rules/neutral_shadow.hpp>

namespace trophic {

/// The neutral shadow of an experiment: its rule table's shadow with the same seed and numbers.
template <class Table, Backend B>
[[nodiscard]] Experiment<rules::neutral_shadow<Table>, B> shadow_of(const Experiment<Table, B>& experiment) {
  Experiment<rules::neutral_shadow<Table>, B> shadow{.seed = experiment.seed,
                                                     .ecology = experiment.ecology,
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

}  // namespace trophic
