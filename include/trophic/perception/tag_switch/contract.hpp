// SPDX-License-Identifier: MIT
// The contract of a slot: when a tag may change.
#pragma once

#include <concepts>
#include <trophic/population/individual.hpp>
#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_TagSwitch                                                                     \
  "bool may_switch(const Individual&, const View&) const and bool restarts(bool switched) const; see " \
  "trophic/perception/tag_switch/contract.hpp"

namespace trophic::perception {

/// `may_switch(self, view)`: whether self's tag may change at this tick; `restarts(switched)`: whether its tag clock then starts
/// again, asked after the brain has chosen another tag (true) or the same (false).
template <class P>
concept TagSwitch = requires(const P policy, const Individual& self, const View& view, bool switched) {
  { policy.may_switch(self, view) } -> std::same_as<bool>;
  { policy.restarts(switched) } -> std::same_as<bool>;
};

}  // namespace trophic::perception
