// SPDX-License-Identifier: MIT
// The contract of a slot: the genome of an individual without a parent.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_InitialGenome                                                                                         \
  "void draw(std::span<double> weights, Rng&) const or void draw(std::span<double> weights, const Individual& newborn, Rng&) " \
  "const; see trophic/reproduction/initial_genome/contract.hpp"

namespace trophic::reproduction {

/// `draw(weights, rng)` or `draw(weights, newborn, rng)`: fills a genome without a parent. The newborn has its id, species and
/// tag, but no genome yet; the id of a founder is the index of its body.
template <class P>
concept InitialGenome = requires(const P policy, std::span<double> weights, Rng& rng) {
  { policy.draw(weights, rng) } -> std::same_as<void>;
}
|| requires(const P policy, std::span<double> weights, const Individual& newborn, Rng& rng) {
  { policy.draw(weights, newborn, rng) } -> std::same_as<void>;
};

namespace ask {

template <class P>
void draw(const P& policy, std::span<double> weights, const Individual& newborn, Rng& rng) {
  const auto& rule = for_species(policy, newborn.species);
  if constexpr (requires { rule.draw(weights, newborn, rng); }) {
    rule.draw(weights, newborn, rng);
  } else {
    rule.draw(weights, rng);
  }
}

}  // namespace ask

}  // namespace trophic::reproduction
