// SPDX-License-Identifier: MIT
// The contract of a slot: which hunters starve.
#pragma once

#include <trophic/perception/visibility/contract.hpp>

#define TROPHIC_SENTENCE_Starvation                                                                               \
  "Starving starving(const View&, const perception::Perceives&) const (with a State also std::span<const State> " \
  "states, with a Clock also const Clock& clock, and Clock start(const View&) const); see trophic/death/starvation/contract.hpp"

namespace trophic::death {

/// The starvation deaths of a tick.
struct Starving {
  std::vector<BodyIndex> victims;  ///< in the order in which they die, each once
  std::vector<BodyIndex> exempt;   ///< hunters saved by an exemption, for observers
  bool restarts_clock = false;     ///< whether the rule's clock restarts after these deaths
  std::vector<Species> due = {};   ///< species whose clocks restart, for a rule with one clock per species
  friend bool operator==(const Starving&, const Starving&) = default;
};

/// A starvation rule with a clock: a nested `struct Clock` of plain numbers that lists its members in `fields()` and is saved in
/// checkpoints. `start(view)` returns a clock that starts now: at the start of a run and after deaths that restart it. With one
/// clock per species, `start(view, clock, due)` restarts those of the species that were due.
template <class P>
concept KeepsClock = requires {
  typename P::Clock;
};

/// The clock of a rule that has none.
struct NoClock {};

namespace detail {

template <class P>
struct clock_of {
  using type = NoClock;
};
template <KeepsClock P>
struct clock_of<P> {
  using type = typename P::Clock;
};

}  // namespace detail

template <class P>
using ClockOf = typename detail::clock_of<P>::type;

/// `starving(view, perceives)`: returns the hunters that starve at this tick; it is called once a tick, after catches and
/// senescence. `perceives(self, other)` is the run's Visibility rule. A rule with a State also takes `states`, one with a Clock
/// also `clock`, in this order. starvation/procedure.hpp composes rules for the time, the victims and the exemptions.
template <class P>
concept Starvation =
    (!KeepsClock<P> &&
     (
         requires(const P policy, const View& view, const perception::Perceives& perceives) {
           { policy.starving(view, perceives) } -> std::same_as<Starving>;
         } ||
         requires(const P policy, const View& view, const perception::Perceives& perceives, AllStates<P> states) {
           { policy.starving(view, perceives, states) } -> std::same_as<Starving>;
         })) ||
    (KeepsClock<P> &&
     requires(const P policy, const View& view) {
       { policy.start(view) } -> std::same_as<ClockOf<P>>;
     } &&
     (
         requires(const P policy, const View& view, const perception::Perceives& perceives, const ClockOf<P> clock) {
           { policy.starving(view, perceives, clock) } -> std::same_as<Starving>;
         } ||
         requires(const P policy, const View& view, const perception::Perceives& perceives, AllStates<P> states,
                  const ClockOf<P> clock) {
           { policy.starving(view, perceives, states, clock) } -> std::same_as<Starving>;
         }));

namespace ask {

template <class P>
[[nodiscard]] Starving starving(const P& policy, [[maybe_unused]] const AllStates<P>& states,
                                [[maybe_unused]] const ClockOf<P>& clock, const View& view,
                                const perception::Perceives& perceives) {
  if constexpr (requires { policy.starving(view, perceives, states, clock); }) {
    return policy.starving(view, perceives, states, clock);
  } else if constexpr (requires { policy.starving(view, perceives, clock); }) {
    return policy.starving(view, perceives, clock);
  } else if constexpr (requires { policy.starving(view, perceives, states); }) {
    return policy.starving(view, perceives, states);
  } else {
    return policy.starving(view, perceives);
  }
}

template <class P>
[[nodiscard]] ClockOf<P> start(const P& policy, [[maybe_unused]] const View& view, [[maybe_unused]] const ClockOf<P>& clock = {},
                               [[maybe_unused]] std::span<const Species> due = {}) {
  if constexpr (requires { policy.start(view, clock, due); }) {
    return policy.start(view, clock, due);
  } else if constexpr (KeepsClock<P>) {
    return policy.start(view);
  } else {
    return {};
  }
}

}  // namespace ask

}  // namespace trophic::death
