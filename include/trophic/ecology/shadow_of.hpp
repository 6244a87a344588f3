// SPDX-License-Identifier: MIT
// An experiment without inheritance.
#pragma once

#include <concepts>
#include <trophic/backend/contract.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/rules/neutral_shadow.hpp>
#include <type_traits>

namespace trophic {

/// The neutral shadow of an experiment: its rule table's shadow with the same seed and numbers.
template <class Table, Backend B>
[[nodiscard]] Experiment<rules::neutral_shadow<Table>, B> shadow_of(const Experiment<Table, B>& experiment) {
  Experiment<rules::neutral_shadow<Table>, B> shadow{.seed = experiment.seed,
                                                     .ecology = experiment.ecology,
                                                     .physics = experiment.physics,
                                                     .rules = {},
                                                     .backend = experiment.backend};
  for_each_slot([&]<RuleSlot slot>() {
    auto& own = of_slot<slot>(shadow.rules);
    const auto& from = of_slot<slot>(experiment.rules);
    if constexpr (std::same_as<std::remove_cvref_t<decltype(own)>, std::remove_cvref_t<decltype(from)>>) own = from;
  });
  return shadow;
}

}  // namespace trophic
