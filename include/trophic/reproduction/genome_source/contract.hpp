// SPDX-License-Identifier: MIT
// The contract of a slot: whether a new controller is random or inherited.
#pragma once

#include <concepts>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_GenomeSource "Descent descent(Rng&) const; see trophic/reproduction/genome_source/contract.hpp"

namespace trophic::reproduction {

/// The origin of a new controller's genome.
enum class Descent {
  random,            ///< drawn at random
  of_parent,         ///< from a parent; without one it is random and labelled random
  of_parent_in_name  ///< from a parent; without one it is random but labelled inherited
};

/// `descent(rng)`: returns the origin of a new controller's genome, which also gives its label if there is no parent.
template <class P>
concept GenomeSource = requires(const P policy, Rng& rng) {
  { policy.descent(rng) } -> std::same_as<Descent>;
};

}  // namespace trophic::reproduction
