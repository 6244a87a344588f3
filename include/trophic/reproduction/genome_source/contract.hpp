// SPDX-License-Identifier: MIT
// The contract of a slot: whether a new controller is random or inherited.
#pragma once

#include <concepts>
#include <trophic/population/individual.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_GenomeSource \
  "bool inherits(Rng&) const and Origin without_parent() const; see trophic/reproduction/genome_source/contract.hpp"

namespace trophic::reproduction {

/// `inherits(rng)`: whether a new controller descends from a parent (else it is random); `without_parent()`: the label of
/// one that should have inherited but found no parent.
template <class P>
concept GenomeSource = requires(const P policy, Rng& rng) {
  { policy.inherits(rng) } -> std::same_as<bool>;
  { policy.without_parent() } -> std::same_as<Origin>;
};

}  // namespace trophic::reproduction
