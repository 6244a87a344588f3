// SPDX-License-Identifier: MIT
// The contract of a slot: heritable traits besides brain, gait and body.
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <trophic/support/rng.hpp>
#include <vector>

#define TROPHIC_SENTENCE_TraitRule                                                                                      \
  "static constexpr std::array<std::string_view, N> trait_names, std::vector<double> draw(Rng&) const and void mutate(" \
  "std::span<double> traits, Rng&) const; see trophic/reproduction/traits/contract.hpp"

namespace trophic::reproduction {

/// A parameter that bounds a trait, and a trait beyond it.
struct BeyondBound {
  std::string parameter;  ///< "sight_m.most"
  double bound = 0.0;
  double trait = 0.0;
};

/// The heritable traits of each individual, numbers that rules read as `view.trait<Sight>(body)`: the genome's part `traits`. A
/// rule that reads a trait names it: `using ReadsTraits = traits::List<Sight>;`; a table without that trait does not compile.
/// `trait_names`: a name per trait, also its column in genomes.csv. `draw(rng)`: returns the traits of an individual without a
/// parent. `mutate(traits, rng)`: changes inherited traits in place. Optional: `std::optional<BeyondBound> beyond(std::span<const
/// double> traits) const` returns the first bound that these are beyond; a run cannot continue from individuals with such traits.
template <class P>
concept TraitRule = requires(const P policy, std::span<double> traits, Rng& rng) {
  std::span<const std::string_view>{P::trait_names};
  { policy.draw(rng) } -> std::same_as<std::vector<double>>;
  { policy.mutate(traits, rng) } -> std::same_as<void>;
};

template <class P>
concept BoundsTraits = TraitRule<P> && requires(const P policy, std::span<const double> traits) {
  { policy.beyond(traits) } -> std::same_as<std::optional<BeyondBound>>;
};

}  // namespace trophic::reproduction
