// SPDX-License-Identifier: MIT
// The contract of a slot: when a newborn becomes fair game.
#pragma once

#include <concepts>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_Activation                                                                                       \
  "bool activates(BodyIndex, const View&) const (with a State also const State& own) and bool restarts_age() const; see " \
  "trophic/death/activation/contract.hpp"

namespace trophic::death {

TROPHIC_QUESTION(activates)

/// `activates(body, view)`: whether the inactive newborn in `body` becomes active at this tick; `restarts_age()`: whether
/// its age counts from then.
template <class P>
concept Activation = requires(const P policy, const StateOf<P> own, BodyIndex body, const View& view) {
  { ask::activates(policy, own, body, view) } -> std::same_as<bool>;
  { policy.restarts_age() } -> std::same_as<bool>;
};

}  // namespace trophic::death
