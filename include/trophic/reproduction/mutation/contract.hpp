// SPDX-License-Identifier: MIT
// The contract of a slot: how a genome changes on the way.
#pragma once

#include <concepts>
#include <span>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Mutation \
  "void mutate(std::span<double> weights, Rng&) const; see trophic/reproduction/mutation/contract.hpp"

namespace trophic::reproduction {

/// `mutate(weights, rng)`: perturbs a genome in place.
template <class P>
concept Mutation = requires(const P policy, std::span<double> weights, Rng& rng) {
  { policy.mutate(weights, rng) } -> std::same_as<void>;
};

}  // namespace trophic::reproduction
