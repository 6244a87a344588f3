// SPDX-License-Identifier: MIT
// The contract of a slot: whom hunger spares.
#pragma once

#include <concepts>
#include <trophic/perception/visibility/contract.hpp>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_Reprieve                                                                                         \
  "bool spared(BodyIndex hunter, const View&, const perception::Perceives&) const (with a State also const State& own); " \
  "see trophic/death/reprieve/contract.hpp"

namespace trophic::death {

TROPHIC_QUESTION(spared)

/// `spared(hunter, view, perceives)`: whether a hungry hunter escapes starvation at this tick. `perceives(self, other)` is the
/// run's Visibility rule.
template <class P>
concept Reprieve = requires(const P policy, const StateOf<P> own, BodyIndex hunter, const View& view,
                            const perception::Perceives& perceives) {
  { ask::spared(policy, own, hunter, view, perceives) } -> std::same_as<bool>;
};

}  // namespace trophic::death
