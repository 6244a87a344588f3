// SPDX-License-Identifier: MIT
// The contract of a slot: when a newborn becomes active.
#pragma once

#include <trophic/population/state.hpp>

#define TROPHIC_SENTENCE_Activation                                                              \
  "Activates activates(BodyIndex, const View&) const (with a State also const State& own); see " \
  "trophic/death/activation/contract.hpp"

namespace trophic::death {

/// Whether a newborn becomes active, and whether its age counts from that moment.
enum class Activates { no, yes, yes_and_restarts_age };

/// `activates(body, view)`: returns whether the inactive newborn in `body` becomes active at this tick.
template <class P>
concept Activation = requires(const P policy, BodyIndex body, const View& view) {
  { policy.activates(body, view) } -> std::same_as<Activates>;
}
|| requires(const P policy, BodyIndex body, const View& view, const StateOf<P> own) {
  { policy.activates(body, view, own) } -> std::same_as<Activates>;
};

namespace ask {

template <class P>
[[nodiscard]] Activates activates(const P& policy, [[maybe_unused]] const StateOf<P>& own, BodyIndex body, const View& view) {
  const auto& rule = for_species(policy, view.robots[body].species);
  if constexpr (requires { rule.activates(body, view, own); }) {
    return rule.activates(body, view, own);
  } else {
    return rule.activates(body, view);
  }
}

}  // namespace ask

}  // namespace trophic::death
