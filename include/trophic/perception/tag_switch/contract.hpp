// SPDX-License-Identifier: MIT
// The contract of a slot: when a tag may change.
#pragma once

#include <trophic/population/state.hpp>

#define TROPHIC_SENTENCE_TagSwitch                                                                        \
  "MaySwitch may_switch(const Individual&, const View&) const (with a State also const State& own); see " \
  "trophic/perception/tag_switch/contract.hpp"

namespace trophic::perception {

/// Whether a tag may change. A change always restarts the tag clock.
enum class MaySwitch {
  no,
  yes,
  yes_and_clock_restarts  ///< even if the brain chooses the same tag again
};

/// `may_switch(self, view)`: returns whether self's tag may change at this tick. Called after its brain has decided.
template <class P>
concept TagSwitch = requires(const P policy, const Individual& self, const View& view) {
  { policy.may_switch(self, view) } -> std::same_as<MaySwitch>;
}
|| requires(const P policy, const Individual& self, const View& view, const StateOf<P> own) {
  { policy.may_switch(self, view, own) } -> std::same_as<MaySwitch>;
};

namespace ask {

template <class P>
[[nodiscard]] MaySwitch may_switch(const P& policy, [[maybe_unused]] const StateOf<P>& own, const Individual& self,
                                   const View& view) {
  const auto& rule = for_species(policy, self.species);
  if constexpr (requires { rule.may_switch(self, view, own); }) {
    return rule.may_switch(self, view, own);
  } else {
    return rule.may_switch(self, view);
  }
}

}  // namespace ask

}  // namespace trophic::perception
