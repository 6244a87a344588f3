// SPDX-License-Identifier: MIT
// The contract of a slot: what an offspring inherits of its parent's genome.
#pragma once

#include <concepts>
#include <trophic/population/individual.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Heredity                                                                                       \
  "std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const, or inherit(std::span<const Ancestor> " \
  "parents, Rng&) const, or with std::span<const std::size_t> neurons before Rng&; see "                                \
  "trophic/reproduction/heredity/contract.hpp"

namespace trophic::reproduction {

/// A heredity of all parents, one or more.
template <class P>
concept HeredityOfAll = requires(const P policy, std::span<const Ancestor> parents, Rng& rng) {
  { policy.inherit(parents, rng) } -> std::same_as<std::shared_ptr<Genome>>;
};

/// A heredity of all parents that also gets the neuron that each weight of their brains enters.
template <class P>
concept HeredityByNeuron = requires(const P policy, std::span<const Ancestor> parents, std::span<const std::size_t> neurons,
                                    Rng& rng) {
  { policy.inherit(parents, neurons, rng) } -> std::same_as<std::shared_ptr<Genome>>;
};

/// `inherit(parent)`: returns the offspring's genome before mutation: the parent's own object or a new one. Null: no genome is
/// passed on; the offspring's is drawn like one without a parent and does not mutate. It gets the first of several parents.
/// `inherit(parents, rng)` gets all; `inherit(parents, neurons, rng)` also the neurons of weights (NamesNeurons in
/// control/brain/contract.hpp).
template <class P>
concept Heredity = HeredityOfAll<P> || HeredityByNeuron<P> || requires(const P policy, const std::shared_ptr<Genome>& parent) {
  { policy.inherit(parent) } -> std::same_as<std::shared_ptr<Genome>>;
};

namespace ask {

template <class P>
[[nodiscard]] std::shared_ptr<Genome> inherit(const P& policy, std::span<const Ancestor> parents,
                                              [[maybe_unused]] std::span<const std::size_t> neurons, [[maybe_unused]] Rng& rng) {
  if constexpr (HeredityByNeuron<P>) {
    return policy.inherit(parents, neurons, rng);
  } else if constexpr (HeredityOfAll<P>) {
    return policy.inherit(parents, rng);
  } else {
    return policy.inherit(parents.front().genome);
  }
}

}  // namespace ask

}  // namespace trophic::reproduction
