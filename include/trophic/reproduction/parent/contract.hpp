// SPDX-License-Identifier: MIT
// The contract of a slot: the parent of the next individual in a vacant body.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Parent                                                                                                 \
  "std::optional<Ancestor> parent(const Vacancy&, const View&, Rng&) const (with a State also std::span<const State> states); " \
  "see "                                                                                                                        \
  "trophic/reproduction/parent/contract.hpp"

namespace trophic::reproduction {

using trophic::Vacancy;

/// `parent(vacancy, view, rng)`: returns the individual that reproduces into the vacant body, dead or alive; without one the
/// genome is random. It must be of the species `vacancy.successor`, if that is given; otherwise the body goes to the parent's
/// species. ByCause has a rule for each cause of death.
template <class P>
concept Parent = requires(const P policy, const Vacancy& vacancy, const View& view, Rng& rng) {
  { policy.parent(vacancy, view, rng) } -> std::same_as<std::optional<Ancestor>>;
}
|| requires(const P policy, const Vacancy& vacancy, const View& view, Rng& rng, AllStates<P> states) {
  { policy.parent(vacancy, view, rng, states) } -> std::same_as<std::optional<Ancestor>>;
};

namespace ask {

template <class P>
[[nodiscard]] std::optional<Ancestor> parent(const P& policy, [[maybe_unused]] const AllStates<P>& states, const Vacancy& vacancy,
                                             const View& view, Rng& rng) {
  const auto& rule = for_species(policy, view.robots[vacancy.body].species);
  if constexpr (requires { rule.parent(vacancy, view, rng, states); }) {
    return rule.parent(vacancy, view, rng, states);
  } else {
    return rule.parent(vacancy, view, rng);
  }
}

}  // namespace ask

}  // namespace trophic::reproduction
