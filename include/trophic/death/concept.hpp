// SPDX-License-Identifier: MIT
// The contracts of death rules: when a newborn becomes fair game, who is caught, who starves, who is sacrificed.
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <trophic/individual.hpp>
#include <trophic/rng.hpp>
#include <trophic/view.hpp>
#include <vector>

namespace trophic::death {

/// A hunter catches a victim.
struct Capture {
  BodyIndex hunter = 0;
  BodyIndex victim = 0;
  friend bool operator==(const Capture&, const Capture&) = default;
};

/// A victim is given up so that a species does not die out: its body goes to `heir`.
struct Sacrifice {
  BodyIndex victim = 0;
  Species heir = 0;
  friend bool operator==(const Sacrifice&, const Sacrifice&) = default;
};

/// When the starvation procedure ran last and the interval fixed then.
struct StarvationClock {
  std::int64_t last_tick = 0;
  std::int64_t interval_ticks = 0;
};

/// `activates(body, view)`: whether the inactive newborn in `body` becomes active at this tick; `restarts_age()`: whether
/// its age counts from then.
template <class P>
concept Activation = requires(const P policy, BodyIndex body, const View& view) {
  { policy.activates(body, view) } -> std::same_as<bool>;
  { policy.restarts_age() } -> std::same_as<bool>;
};

/// `captures(view, rng)`: everybody caught at this tick, in order; each victim once.
template <class P>
concept CaptureRule = requires(const P policy, const View& view, Rng& rng) {
  { policy.captures(view, rng) } -> std::same_as<std::vector<Capture>>;
};

/// `may_die(species, view)`: whether a member of a hunted species may be caught or sacrificed now.
template <class P>
concept Floor = requires(const P policy, Species species, const View& view) {
  { policy.may_die(species, view) } -> std::same_as<bool>;
};

/// `interval_ticks(view)`: ticks between two starvation procedures as of now; `due(clock, view)`: whether one is held at
/// this tick.
template <class P>
concept StarvationSchedule = requires(const P policy, const StarvationClock& clock, const View& view) {
  { policy.interval_ticks(view) } -> std::same_as<std::int64_t>;
  { policy.due(clock, view) } -> std::same_as<bool>;
};

/// `victim(view, spared)`: who starves in a procedure, given whom the Reprieve rule spares; nobody: nobody dies.
template <class P>
concept Starvation = requires(const P policy, const View& view, const std::function<bool(BodyIndex)>& spared) {
  { policy.victim(view, spared) } -> std::same_as<std::optional<BodyIndex>>;
};

/// `spared(hunter, view)`: whether a hungry hunter escapes starvation at this tick.
template <class P>
concept Reprieve = requires(const P policy, BodyIndex hunter, const View& view) {
  { policy.spared(hunter, view) } -> std::same_as<bool>;
};

/// `sacrifices(view, rng)`: who is given up at this tick.
template <class P>
concept Rescue = requires(const P policy, const View& view, Rng& rng) {
  { policy.sacrifices(view, rng) } -> std::same_as<std::vector<Sacrifice>>;
};

/// `dies(individual, view, rng)`: whether an individual dies of itself at this tick; its body stays with its species.
template <class P>
concept Senescence = requires(const P policy, const Individual& individual, const View& view, Rng& rng) {
  { policy.dies(individual, view, rng) } -> std::same_as<bool>;
};

}  // namespace trophic::death
