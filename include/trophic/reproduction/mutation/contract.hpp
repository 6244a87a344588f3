// SPDX-License-Identifier: MIT
// The contract of a slot: the mutation of an inherited genome.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Mutation                                                                                        \
  "void mutate(std::span<double> weights, const Individual& offspring, Rng&) const (with a State also State& own); see " \
  "trophic/reproduction/mutation/contract.hpp"

namespace trophic::reproduction {

/// `mutate(weights, offspring, rng)`: perturbs an inherited genome in place. `offspring` is complete except for its genome.
/// With a State, `own` is the offspring's state at birth and may change, for example a mutation rate that itself mutates.
template <class P>
concept Mutation = requires(const P policy, std::span<double> weights, const Individual& offspring, Rng& rng) {
  { policy.mutate(weights, offspring, rng) } -> std::same_as<void>;
}
|| requires(const P policy, std::span<double> weights, const Individual& offspring, Rng& rng, StateOf<P> own) {
  { policy.mutate(weights, offspring, rng, own) } -> std::same_as<void>;
};

namespace ask {

template <class P>
void mutate(const P& policy, [[maybe_unused]] StateOf<P>& own, std::span<double> weights, const Individual& offspring, Rng& rng) {
  const auto& rule = for_species(policy, offspring.species);
  if constexpr (requires { rule.mutate(weights, offspring, rng, own); }) {
    return rule.mutate(weights, offspring, rng, own);
  } else {
    return rule.mutate(weights, offspring, rng);
  }
}

}  // namespace ask

}  // namespace trophic::reproduction
