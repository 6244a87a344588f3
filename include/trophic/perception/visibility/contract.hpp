// SPDX-License-Identifier: MIT
// The contract of a slot: who can perceive whom.
#pragma once

#include <concepts>
#include <functional>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Visibility                                                                                     \
  "bool perceives(BodyIndex self, BodyIndex other, const View&, Rng&) const (with a State also const State& own); see " \
  "trophic/perception/visibility/contract.hpp"

namespace trophic::perception {

TROPHIC_QUESTION(perceives)

/// `perceives(self, other, view, rng)`: whether who lives in body self can perceive who lives in body other. Species are checked
/// elsewhere. The stream is that of the two and the tick: asked again within a tick, a noisy rule says the same, and whom else
/// self looks at does not matter.
template <class P>
concept Visibility = requires(const P policy, const StateOf<P> own, BodyIndex self, BodyIndex other, const View& view, Rng& rng) {
  { ask::perceives(policy, own, self, other, view, rng) } -> std::same_as<bool>;
};

/// The Visibility rule of a run at one tick, as other rules may ask it.
using Perceives = std::function<bool(BodyIndex self, BodyIndex other)>;

}  // namespace trophic::perception
