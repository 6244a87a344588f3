// SPDX-License-Identifier: MIT
// The contracts of birth rules: where a new controller comes from and how it differs from its parent's.
#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <span>
#include <trophic/individual.hpp>
#include <trophic/rng.hpp>
#include <trophic/view.hpp>

namespace trophic::reproduction {

/// A body that is about to change hands; its occupant is still in the view.
struct Vacancy {
  BodyIndex body = 0;
  Cause cause = Cause::caught;
  std::optional<BodyIndex> killer = {};  ///< the body of the hunter, for Cause::caught
  std::optional<Species> heir = {};  ///< the species that the body goes to, where the rules fix it: a parent must be one of it
};

/// `draw(weights, rng)`: fills a genome that has no parent.
template <class P>
concept InitialGenome = requires(const P policy, std::span<double> weights, Rng& rng) {
  { policy.draw(weights, rng) } -> std::same_as<void>;
};

/// `inherits(rng)`: whether a new controller descends from a parent (else it is random); `without_parent()`: the label of
/// one that should have inherited but found no parent.
template <class P>
concept GenomeSource = requires(const P policy, Rng& rng) {
  { policy.inherits(rng) } -> std::same_as<bool>;
  { policy.without_parent() } -> std::same_as<Origin>;
};

/// `parent(vacancy, view, rng)`: who reproduces into the vacant body, dead or alive; nobody: the genome is random. Of the species
/// `vacancy.heir` where that is given; where not, the body goes to the parent's species.
template <class P>
concept Parent = requires(const P policy, const Vacancy& vacancy, const View& view, Rng& rng) {
  { policy.parent(vacancy, view, rng) } -> std::same_as<std::optional<Ancestor>>;
};

/// `mutate(weights, rng)`: perturbs a genome in place.
template <class P>
concept Mutation = requires(const P policy, std::span<double> weights, Rng& rng) {
  { policy.mutate(weights, rng) } -> std::same_as<void>;
};

/// `inherit(parent)`: the genome that the offspring starts from, before mutation; the parent's own object or a new one. Nothing:
/// no genome is passed on, the offspring's is drawn as one without a parent and does not mutate.
template <class P>
concept Heredity = requires(const P policy, const std::shared_ptr<Genome>& parent) {
  { policy.inherit(parent) } -> std::same_as<std::shared_ptr<Genome>>;
};

}  // namespace trophic::reproduction
