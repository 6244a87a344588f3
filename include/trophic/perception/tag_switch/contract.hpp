// SPDX-License-Identifier: MIT
// The contract of a slot: when a tag may change.
#pragma once

#include <concepts>
#include <trophic/population/individual.hpp>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_TagSwitch                                                                                     \
  "bool may_switch(const Individual&, const View&) const (with a State also const State& own) and bool restarts(bool " \
  "switched) const; see trophic/perception/tag_switch/contract.hpp"

namespace trophic::perception {

TROPHIC_QUESTION(may_switch)

/// `may_switch(self, view)`: whether self's tag may change at this tick; `restarts(switched)`: whether its tag clock then starts
/// again, asked after the brain has chosen another tag (true) or the same (false).
template <class P>
concept TagSwitch = requires(const P policy, const StateOf<P> own, const Individual& self, const View& view, bool switched) {
  { ask::may_switch(policy, own, self, view) } -> std::same_as<bool>;
  { policy.restarts(switched) } -> std::same_as<bool>;
};

}  // namespace trophic::perception
