// SPDX-License-Identifier: MIT
// The contract of a slot: what an offspring inherits of its parent's genome.
#pragma once

#include <concepts>
#include <trophic/population/individual.hpp>

#define TROPHIC_SENTENCE_Heredity \
  "std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const; see trophic/reproduction/heredity/contract.hpp"

namespace trophic::reproduction {

/// `inherit(parent)`: returns the offspring's genome before mutation: the parent's own object or a new one. Null: no genome is
/// passed on; the offspring's is drawn like one without a parent and does not mutate.
template <class P>
concept Heredity = requires(const P policy, const std::shared_ptr<Genome>& parent) {
  { policy.inherit(parent) } -> std::same_as<std::shared_ptr<Genome>>;
};

}  // namespace trophic::reproduction
