// SPDX-License-Identifier: MIT
// No individual is sacrificed for a species that dies out.
#pragma once

#include <trophic/death/minimum_predators/contract.hpp>

namespace trophic::death::minimum_predators {

/// Rule: no individual is sacrificed, so hunters may die out.   Reads: nothing.   Random draws: 0.
struct NoMinimum {
  static constexpr std::string_view name = "no_minimum";
  static constexpr std::string_view source = "control";
  [[nodiscard]] std::vector<Sacrifice> sacrifices(const View&, Rng&) const { return {}; }
};
static_assert(MinimumPredators<NoMinimum>);

}  // namespace trophic::death::minimum_predators
