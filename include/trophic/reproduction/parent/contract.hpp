// SPDX-License-Identifier: MIT
// The contract of a slot: who reproduces into a vacant body.
#pragma once

#include <concepts>
#include <optional>
#include <trophic/population/individual.hpp>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Parent                                                                                        \
  "std::optional<Ancestor> parent(const Vacancy&, const View&, Rng&) const (with a State also const State& own); see " \
  "trophic/reproduction/parent/contract.hpp"

namespace trophic::reproduction {

/// A body that is about to change hands; its occupant is still in the view.
struct Vacancy {
  BodyIndex body = 0;
  Cause cause = Cause::caught;
  std::optional<BodyIndex> killer = {};  ///< the body of the hunter, for Cause::caught
  std::optional<Species> heir = {};  ///< the species that the body goes to, where the rules fix it: a parent must be one of it
};

TROPHIC_QUESTION(parent)

/// `parent(vacancy, view, rng)`: who reproduces into the vacant body, dead or alive; nobody: the genome is random. Of the species
/// `vacancy.heir` where that is given; where not, the body goes to the parent's species. With a State, `own` is the vacant
/// body's.
template <class P>
concept Parent = requires(const P policy, const StateOf<P> own, const Vacancy& vacancy, const View& view, Rng& rng) {
  { ask::parent(policy, own, vacancy, view, rng) } -> std::same_as<std::optional<Ancestor>>;
};

}  // namespace trophic::reproduction
