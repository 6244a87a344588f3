// SPDX-License-Identifier: MIT
// After a sacrifice the body's last killer reproduces.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::reproduction::parent {

/// Rule (released code, for sacrificed prey): the parent is the hunter that last caught an individual in this body, dead or
/// alive. There is none without a catch, or if that hunter is not of the species to which the body goes.   Reads: its own state.
/// Random draws: 0.
struct LastKiller {
  static constexpr std::string_view name = "last_killer";
  static constexpr std::string_view source = "released code";

  /// The state of a body.
  struct State {
    std::optional<Ancestor> killer;  ///< the last hunter that caught an individual in it
    static constexpr auto fields() { return std::tuple{field("killer", &State::killer)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State& body) const { return body; }
  void on_caught(State& own, BodyIndex, BodyIndex hunter, const View& view) const {
    own.killer = view.robots[hunter].as_ancestor();
  }

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View&, Rng&, std::span<const State> states) const {
    const std::optional<Ancestor>& killer = states[vacancy.body].killer;
    return killer && vacancy.successor && killer->species != *vacancy.successor ? std::nullopt : killer;
  }
};
static_assert(Parent<LastKiller>);

}  // namespace trophic::reproduction::parent
