// SPDX-License-Identifier: MIT
// The contract of a slot: who is given up so that a species does not die out.
#pragma once

#include <concepts>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

#define TROPHIC_SENTENCE_MinimumPredators                                                                              \
  "std::vector<Sacrifice> sacrifices(const View&, Rng&) const (with a State also std::span<const State> states); see " \
  "trophic/death/minimum_predators/contract.hpp"

namespace trophic::death {

/// A victim is given up so that a species does not die out: its body goes to `heir`.
struct Sacrifice {
  BodyIndex victim = 0;
  Species successor = 0;
  friend bool operator==(const Sacrifice&, const Sacrifice&) = default;
};

/// `sacrifices(view, rng)`: who is given up at this tick, nobody twice: who is born of one sacrifice is spared the others.
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
