// SPDX-License-Identifier: MIT
// A rescued species takes its newcomer from the body's last killer.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <trophic/params/params.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <tuple>

namespace trophic::reproduction::parent {

/// Rule (released code, for sacrificed prey): the parent is whoever last caught somebody in this body, dead or alive;
/// nobody ever, or one of another species than the body goes to: none.   Reads: its own state.   Random draws: 0.
struct LastKiller {
  static constexpr std::string_view name = "last_killer";
  static constexpr std::string_view source = "released code";

  /// Of each body.
  struct State {
    std::optional<Ancestor> killer;  ///< who last caught somebody in it
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
