// SPDX-License-Identifier: MIT
// The contract of a slot: death of natural causes.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Senescence                                                                  \
  "bool dies(const Individual&, const View&, Rng&) const (with a State also const State& own); see " \
  "trophic/death/senescence/contract.hpp"

namespace trophic::death {

/// `dies(individual, view, rng)`: returns whether an individual dies of natural causes at this tick; its body stays with its
/// species. A rule names its cause of death by `static constexpr std::string_view cause`; the default is `senescence`.
template <class P>
concept Senescence = requires(const P policy, const Individual& individual, const View& view, Rng& rng) {
  { policy.dies(individual, view, rng) } -> std::same_as<bool>;
}
|| requires(const P policy, const Individual& individual, const View& view, Rng& rng, const StateOf<P> own) {
  { policy.dies(individual, view, rng, own) } -> std::same_as<bool>;
};

namespace ask {

template <class P>
[[nodiscard]] bool dies(const P& policy, [[maybe_unused]] const StateOf<P>& own, const Individual& individual, const View& view,
                        Rng& rng) {
  const auto& rule = for_species(policy, individual.species);
  if constexpr (requires { rule.dies(individual, view, rng, own); }) {
    return rule.dies(individual, view, rng, own);
  } else {
    return rule.dies(individual, view, rng);
  }
}

/// Returns the cause of deaths by this rule.
template <class P>
[[nodiscard]] Cause cause(const P&) {
  if constexpr (requires { AnswersForSpecies<P>::cause; }) return cause_named(AnswersForSpecies<P>::cause);
  return Cause::senescence;
}

}  // namespace ask

}  // namespace trophic::death
