// SPDX-License-Identifier: MIT
// The contract of a slot: who starves.
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_Starvation                                                                           \
  "std::optional<BodyIndex> victim(const View&, const std::function<bool(BodyIndex)>& spared) const (with a " \
  "State also std::span<const State> states); see trophic/death/starvation/contract.hpp"

namespace trophic::death {

TROPHIC_QUESTION(victim)

/// `victim(view, spared)`: who starves in a procedure, given whom the Reprieve rule spares; nobody: nobody dies.
template <class P>
concept Starvation = requires(const P policy, const std::span<const StateOf<P>> states, const View& view,
                              const std::function<bool(BodyIndex)>& spared) {
  { ask::victim(policy, states, view, spared) } -> std::same_as<std::optional<BodyIndex>>;
};

}  // namespace trophic::death
