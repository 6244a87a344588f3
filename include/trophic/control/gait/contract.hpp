// SPDX-License-Identifier: MIT
// The contract of a slot: the gait with which an individual walks.
#pragma once

#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_GaitRule \
  "Gait express(std::span<const double> genes, const RobotModel&, const Habitat&) const; see trophic/control/gait/contract.hpp"

namespace trophic::control {

/// `express(genes, robot, habitat)`: returns the gait of this robot; a pure function. Throws std::invalid_argument for genes or a
/// robot that have no gait under this rule. A policy whose gaits are inherited also satisfies InheritedGait; `genes` is empty for
/// others.
template <class P>
concept GaitRule = requires(const P policy, std::span<const double> genes, const RobotModel& robot, const Habitat& habitat) {
  { policy.express(genes, robot, habitat) } -> std::same_as<Gait>;
};

/// A gait with its own genes, the genome's part `gait`. `draw(robot, habitat, rng)`: returns the genes of an individual without a
/// parent, at least one. `mutate(genes, offspring, rng)`: changes inherited genes in place, and may change their number. The body
/// may have changed too, so `express` must accept the genes for any robot. Optional: `std::vector<std::size_t>
/// structure(std::span<const double> genes) const` returns the indices of the genes that are structure, such as the links of a
/// network, which must be equal in the parents for a crossover to mix the others; without it all genes are values.
template <class P>
concept InheritedGait = GaitRule<P> && requires(const P policy, const RobotModel& robot, const Habitat& habitat,
                                                std::vector<double>& genes, const Individual& offspring, Rng& rng) {
  { policy.draw(robot, habitat, rng) } -> std::same_as<std::vector<double>>;
  { policy.mutate(genes, offspring, rng) } -> std::same_as<void>;
};

/// An inherited gait with genes that are structure.
template <class P>
concept StructuredGait = InheritedGait<P> && requires(const P policy, std::span<const double> genes) {
  { policy.structure(genes) } -> std::same_as<std::vector<std::size_t>>;
};

/// An inherited gait that newborns improve before birth. `learn(genes, robot, habitat, newborn, nursery, rng)`: changes the genes
/// in place, after they were drawn or mutated.
template <class P>
concept LearntGait = InheritedGait<P> &&
    requires(const P policy, const RobotModel& robot, const Habitat& habitat, std::vector<double>& genes,
             const Individual& newborn, const Nursery& nursery, Rng& rng) {
  { policy.learn(genes, robot, habitat, newborn, nursery, rng) } -> std::same_as<void>;
};

namespace ask {

/// Returns the gaits that a rule names in its optional `gaits()`; they are loaded with the habitat.
template <class P>
[[nodiscard]] std::vector<std::string> gaits([[maybe_unused]] const P& policy) {
  if constexpr (requires { policy.gaits(); }) return policy.gaits();
  return {};
}

/// Returns the indices of the genes that are structure.
template <class P>
[[nodiscard]] std::vector<std::size_t> gait_structure([[maybe_unused]] const P& policy,
                                                      [[maybe_unused]] std::span<const double> genes) {
  if constexpr (StructuredGait<P>) return policy.structure(genes);
  return {};
}

}  // namespace ask

}  // namespace trophic::control
