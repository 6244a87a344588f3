// SPDX-License-Identifier: MIT
// The contract of a slot: the body with which an individual is born.
#pragma once

#include <concepts>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_BodyPlan                                                                 \
  "body::Design grow(std::span<const double> genes, Species species, const Habitat&) const; see " \
  "trophic/reproduction/body_plan/contract.hpp"

namespace trophic::reproduction {

/// `grow(genes, species, habitat)`: returns the body of these genes; a pure function. Throws std::invalid_argument for genes that
/// are not this policy's. A policy whose bodies are inherited also satisfies InheritedBody; `genes` is empty for others.
template <class P>
concept BodyPlan = requires(const P policy, std::span<const double> genes, Species species, const Habitat& habitat) {
  { policy.grow(genes, species, habitat) } -> std::same_as<body::Design>;
};

/// A body with its own genes, the genome's part `body`. `draw(species, habitat, rng)`: returns the genes of an individual without
/// a parent, at least one. `mutate(genes, offspring, habitat, rng)`: changes inherited genes in place, and may change their
/// number. Both are repeated if the result cannot be built or the rule Viability refuses it. A policy whose genes are those of
/// habitat/body/plan.hpp declares `static constexpr bool genes_are_modules = true;`: a crossover then mixes bodies by subtrees.
template <class P>
concept InheritedBody = BodyPlan<P> && requires(const P policy, Species species, const Habitat& habitat,
                                                std::vector<double>& genes, const Individual& offspring, Rng& rng) {
  { policy.draw(species, habitat, rng) } -> std::same_as<std::vector<double>>;
  { policy.mutate(genes, offspring, habitat, rng) } -> std::same_as<void>;
};

/// Returns whether the genes of a body are a plan of modules.
template <class P>
inline constexpr bool genes_are_modules = requires {
  requires P::genes_are_modules;
};

namespace ask {

/// Returns the robots that a rule names in its optional `robots()`; they are loaded with the habitat.
template <class P>
[[nodiscard]] std::vector<std::string> robots([[maybe_unused]] const P& policy) {
  if constexpr (requires { policy.robots(); }) return policy.robots();
  return {};
}

}  // namespace ask

}  // namespace trophic::reproduction
