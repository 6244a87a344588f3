// SPDX-License-Identifier: MIT
// The contract of a slot: the genome of an individual without a parent.
#pragma once

#include <concepts>
#include <span>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_InitialGenome \
  "void draw(std::span<double> weights, Rng&) const; see trophic/reproduction/initial_genome/contract.hpp"

namespace trophic::reproduction {

/// `draw(weights, rng)`: fills a genome that has no parent.
template <class P>
concept InitialGenome = requires(const P policy, std::span<double> weights, Rng& rng) {
  { policy.draw(weights, rng) } -> std::same_as<void>;
};

}  // namespace trophic::reproduction
