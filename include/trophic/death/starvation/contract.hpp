// SPDX-License-Identifier: MIT
// The contract of a slot: who starves.
#pragma once

#include <concepts>
#include <span>
#include <trophic/params/params.hpp>
#include <trophic/perception/visibility/contract.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/state.hpp>
#include <trophic/population/view.hpp>
#include <vector>

#define TROPHIC_SENTENCE_Starvation                                                                               \
  "Starving starving(const View&, const perception::Perceives&) const (with a State also std::span<const State> " \
  "states, with a Clock also const Clock& clock, and Clock start(const View&) const); see trophic/death/starvation/contract.hpp"

namespace trophic::death {

/// Who starves at a tick.
struct Starving {
  std::vector<BodyIndex> victims;  ///< in the order in which they die, each once
  std::vector<BodyIndex> exempt;   ///< hunters that were to starve and that an exemption saves, for observers
  bool restarts_clock = false;     ///< whether the rule's clock starts anew after these deaths
  friend bool operator==(const Starving&, const Starving&) = default;
};

/// A starvation rule that keeps a clock: a nested `struct Clock` of plain numbers that lists its members by `fields()`, which
/// checkpoints hold. `start(view)` is a clock that starts now: at the start of a run, and after deaths that restart it.
template <class P>
concept KeepsClock = requires {
  typename P::Clock;
};

/// The Clock of a rule without one.
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

/// `starving(view, perceives)`: who starves at this tick, asked once a tick after catches and deaths of old age.
/// `perceives(self, other)` is the run's Visibility rule. With a State also `states`, with a Clock also `clock`, in this
/// order. starvation/procedure.hpp composes rules of when, who, and who is exempt.
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
[[nodiscard]] ClockOf<P> start(const P& policy, [[maybe_unused]] const View& view) {
  if constexpr (KeepsClock<P>) {
    return policy.start(view);
  } else {
    return {};
  }
}

}  // namespace ask

}  // namespace trophic::death
