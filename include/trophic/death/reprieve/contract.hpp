// SPDX-License-Identifier: MIT
// The contract of a slot: who escapes starvation.
#pragma once

#include <concepts>
#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_Reprieve "bool spared(BodyIndex hunter, const View&) const; see trophic/death/reprieve/contract.hpp"

namespace trophic::death {

/// `spared(hunter, view)`: whether a hungry hunter escapes starvation at this tick.
template <class P>
concept Reprieve = requires(const P policy, BodyIndex hunter, const View& view) {
  { policy.spared(hunter, view) } -> std::same_as<bool>;
};

}  // namespace trophic::death
