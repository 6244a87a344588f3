// SPDX-License-Identifier: MIT
// The contract of a slot: who reproduces into a vacant body.
#pragma once

#include <concepts>
#include <optional>
#include <trophic/population/individual.hpp>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Parent                                                                                                 \
  "std::optional<Ancestor> parent(const Vacancy&, const View&, Rng&) const (with a State also std::span<const State> states); " \
  "see "                                                                                                                        \
  "trophic/reproduction/parent/contract.hpp"

namespace trophic::reproduction {

/// A body that is about to change hands; its occupant is still in the view.
struct Vacancy {
  BodyIndex body = 0;
  Cause cause = Cause::caught;
  std::optional<BodyIndex> killer = {};  ///< the body of the hunter, for Cause::caught
  std::optional<Species> successor =
      {};  ///< the species that the body goes to, where the rules fix it: a parent must be one of it
};

/// `parent(vacancy, view, rng)`: who reproduces into the vacant body, dead or alive; nobody: the genome is random. Of the species
/// `vacancy.heir` where that is given; where not, the body goes to the parent's species. ByCause has a rule for each cause of
/// death.
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
