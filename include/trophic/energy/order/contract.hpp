// SPDX-License-Identifier: MIT
// The contract of a slot: the order in which the individuals of a tick act.
#pragma once

#include <concepts>
#include <trophic/population/individual.hpp>

#define TROPHIC_SENTENCE_Order "bool in_turn() const; see trophic/energy/order/contract.hpp"

namespace trophic {

/// The individuals that act at a moment of a tick: here all individuals.
struct AllAct {
  static constexpr std::uint64_t turn = 0;
  [[nodiscard]] bool operator()(const Individual& one) const { return one.lives(); }
  [[nodiscard]] constexpr bool has(Species) const { return true; }
};

/// The individuals of one species.
struct SpeciesActs {
  Species turn = 0;
  [[nodiscard]] constexpr bool operator()(const Individual& one) const { return one.species == turn; }
  [[nodiscard]] constexpr bool has(Species species) const { return species == turn; }
};

}  // namespace trophic

namespace trophic::energy {

/// `in_turn()`: returns whether species act in turn, in the order of the community. If so, all members of a species spend, bite,
/// catch, age, starve by the rule Metabolism and give birth before the next species does, and the resource grows after the last
/// one. Otherwise all individuals spend, the resource grows, all bite, all catch, and so on; births come last. In both orders all
/// bodies have moved before, and the rules Starvation and MinimumPredators act after all other deaths.
template <class P>
concept Order = requires(const P policy) {
  { policy.in_turn() } -> std::same_as<bool>;
};

}  // namespace trophic::energy
