// SPDX-License-Identifier: MIT
// The contract of a slot: whether a new controller is random or inherited.
#pragma once

#include <concepts>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_GenomeSource "Descent descent(Rng&) const; see trophic/reproduction/genome_source/contract.hpp"

namespace trophic::reproduction {

/// Where a new controller's genome comes from.
enum class Descent {
  random,            ///< drawn at random
  of_parent,         ///< from a parent; without one it is random, and labelled so
  of_parent_in_name  ///< from a parent; without one it is random, and labelled inherited
};

/// `descent(rng)`: where a new controller's genome comes from, and how one without a parent is labelled.
template <class P>
concept GenomeSource = requires(const P policy, Rng& rng) {
  { policy.descent(rng) } -> std::same_as<Descent>;
};

}  // namespace trophic::reproduction
