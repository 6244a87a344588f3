// SPDX-License-Identifier: MIT
// The contract of a slot: what an offspring inherits from its parent's genome.
#pragma once

#include <concepts>
#include <trophic/population/individual.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Heredity                                                                                       \
  "std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const, or inherit(std::span<const Ancestor> " \
  "parents, Rng&) const, or with const GenomeStructure& after Rng&; see trophic/reproduction/heredity/contract.hpp"

namespace trophic::reproduction {

/// The structure of a genome, according to the policies of its parts: the indices of the numbers that are structure, such as the
/// links of a growing network. All other numbers, and all traits, are values. Genomes with equal structure have equal numbers at
/// these indices.
struct GenomeStructure {
  std::vector<std::size_t> weights = {};     ///< by the rule Brain: all but `weights_of`
  std::vector<std::size_t> gait_genes = {};  ///< by the rule Gait: `structure`
  bool has_modules = false;                  ///< by the rule BodyPlan: `genes_are_modules`
  std::vector<std::size_t> neurons = {};     ///< the neuron that each weight enters (NamesNeurons in control/brain/contract.hpp)
};

/// A heredity that uses all parents, one or more.
template <class P>
concept HeredityOfAll = requires(const P policy, std::span<const Ancestor> parents, Rng& rng) {
  { policy.inherit(parents, rng) } -> std::same_as<std::shared_ptr<Genome>>;
};

/// A heredity that uses all parents and the structure of the first one's genome.
template <class P>
concept HeredityByStructure = requires(const P policy, std::span<const Ancestor> parents, Rng& rng,
                                       const GenomeStructure& structure) {
  { policy.inherit(parents, rng, structure) } -> std::same_as<std::shared_ptr<Genome>>;
};

/// A heredity for brains that name the neurons of their weights: `static constexpr bool mixes_neurons = true;`.
template <class P>
concept MixesNeurons = HeredityByStructure<P> && requires {
  requires P::mixes_neurons;
};

/// `inherit(parent)`: returns the offspring's genome before mutation: the parent's own object or a new one. Null means that no
/// genome is passed on; the offspring's is then drawn as without a parent and does not mutate. `parent` is the first of several
/// parents. `inherit(parents, rng)` gets all of them; `inherit(parents, rng, structure)` also the structure of the first one's
/// genome.
template <class P>
concept Heredity = HeredityOfAll<P> || HeredityByStructure<P> || requires(const P policy, const std::shared_ptr<Genome>& parent) {
  { policy.inherit(parent) } -> std::same_as<std::shared_ptr<Genome>>;
};

namespace ask {

template <class P>
[[nodiscard]] std::shared_ptr<Genome> inherit(const P& policy, std::span<const Ancestor> parents, [[maybe_unused]] Rng& rng,
                                              [[maybe_unused]] const GenomeStructure& structure) {
  if constexpr (HeredityByStructure<P>) {
    return policy.inherit(parents, rng, structure);
  } else if constexpr (HeredityOfAll<P>) {
    return policy.inherit(parents, rng);
  } else {
    return policy.inherit(parents.front().genome);
  }
}

}  // namespace ask

}  // namespace trophic::reproduction
