// SPDX-License-Identifier: MIT
// The contract of a slot: which individuals are caught.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_CaptureRule                                                                               \
  "std::vector<Capture> captures(const View&, Rng&) const (with a State also std::span<const State> states); see " \
  "trophic/death/capture/contract.hpp"

namespace trophic::death {

/// A hunter catches a victim.
struct Capture {
  BodyIndex hunter = 0;
  BodyIndex victim = 0;
  friend bool operator==(const Capture&, const Capture&) = default;
};

/// `captures(view, rng)`: returns all catches of this tick, in order, with each victim once. Optional, for by_species: a last
/// argument `std::optional<Species> only`, the species of the hunters (all if empty). If catches depend on the assignment of
/// individuals to bodies, the rule declares `static constexpr bool depends_on_order_of_bodies = true;`.
template <class P>
concept CaptureRule = requires(const P policy, const View& view, Rng& rng) {
  { policy.captures(view, rng) } -> std::same_as<std::vector<Capture>>;
}
|| requires(const P policy, const View& view, Rng& rng, std::span<const StateOf<P>> states) {
  { policy.captures(view, rng, states) } -> std::same_as<std::vector<Capture>>;
};

namespace detail {

/// The catches of a rule that differs by species; defined in detail/by_species.hpp, which rules/by_species.hpp includes.
template <class P>
[[nodiscard]] std::vector<Capture> captures_by_species(const P& policy, std::span<const StateOf<P>> states, const View& view,
                                                       Rng& rng);

}  // namespace detail

namespace ask {

template <class P>
[[nodiscard]] std::vector<Capture> captures(const P& policy, [[maybe_unused]] std::span<const StateOf<P>> states,
                                            const View& view, Rng& rng) {
  if constexpr (!std::same_as<AnswersForSpecies<P>, P>) {
    return detail::captures_by_species(policy, states, view, rng);
  } else if constexpr (requires { policy.captures(view, rng, states); }) {
    return policy.captures(view, rng, states);
  } else {
    return policy.captures(view, rng);
  }
}

}  // namespace ask

}  // namespace trophic::death
