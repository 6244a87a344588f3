// SPDX-License-Identifier: MIT
// The contract of a slot: which individuals are sacrificed so that a species does not die out.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_MinimumPredators                                                                              \
  "std::vector<Sacrifice> sacrifices(const View&, Rng&) const (with a State also std::span<const State> states); see " \
  "trophic/death/minimum_predators/contract.hpp"

namespace trophic::death {

/// A victim is sacrificed so that a species does not die out: its body goes to the species `successor`.
struct Sacrifice {
  BodyIndex victim = 0;
  Species successor = 0;
  friend bool operator==(const Sacrifice&, const Sacrifice&) = default;
};

/// `sacrifices(view, rng)`: returns the sacrifices of this tick, with each victim once; individuals born in this tick are not
/// sacrificed.
template <class P>
concept MinimumPredators = requires(const P policy, const View& view, Rng& rng) {
  { policy.sacrifices(view, rng) } -> std::same_as<std::vector<Sacrifice>>;
}
|| requires(const P policy, const View& view, Rng& rng, std::span<const StateOf<P>> states) {
  { policy.sacrifices(view, rng, states) } -> std::same_as<std::vector<Sacrifice>>;
};

namespace ask {

template <class P>
[[nodiscard]] std::vector<Sacrifice> sacrifices(const P& policy, [[maybe_unused]] std::span<const StateOf<P>> states,
                                                const View& view, Rng& rng) {
  if constexpr (requires { policy.sacrifices(view, rng, states); }) {
    return policy.sacrifices(view, rng, states);
  } else {
    return policy.sacrifices(view, rng);
  }
}

}  // namespace ask

}  // namespace trophic::death
