// SPDX-License-Identifier: MIT
// The contract of a slot: who dies of itself.
#pragma once

#include <concepts>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Senescence                                                                  \
  "bool dies(const Individual&, const View&, Rng&) const (with a State also const State& own); see " \
  "trophic/death/senescence/contract.hpp"

namespace trophic::death {

TROPHIC_QUESTION(dies)

/// `dies(individual, view, rng)`: whether an individual dies of itself at this tick; its body stays with its species.
template <class P>
concept Senescence = requires(const P policy, const StateOf<P> own, const Individual& individual, const View& view, Rng& rng) {
  { ask::dies(policy, own, individual, view, rng) } -> std::same_as<bool>;
};

}  // namespace trophic::death
