// SPDX-License-Identifier: MIT
// Individuals inherit only brain, gait and body.
#pragma once

#include <trophic/reproduction/traits/contract.hpp>

namespace trophic::reproduction::traits {

/// Rule: no traits, as in the paper.   Reads: nothing.   Random draws: 0.
struct NoTraits {
  static constexpr std::string_view name = "no_traits";
  static constexpr std::string_view source = "paper: no such rule";
  static constexpr std::array<std::string_view, 0> trait_names{};
  [[nodiscard]] std::vector<double> draw(Rng&) const { return {}; }
  void mutate(std::span<double>, Rng&) const {}
};
static_assert(TraitRule<NoTraits>);

}  // namespace trophic::reproduction::traits
