// SPDX-License-Identifier: MIT
// A rescued species takes its newcomer from the body's last killer.
#pragma once

#include <optional>
#include <string_view>
#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::reproduction::parent {

/// Rule (released code, for sacrificed prey): the parent is whoever last caught somebody in this body, dead or alive;
/// nobody ever, or one of another species than the body goes to: none.   Reads: body memory.   Random draws: 0.
struct LastKiller {
  static constexpr std::string_view name = "last_killer";
  static constexpr std::string_view source = "released code";
  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&) const {
    const std::optional<Ancestor>& killer = view.robots[vacancy.body].memory.last_killer;
    return killer && vacancy.heir && killer->species != *vacancy.heir ? std::nullopt : killer;
  }
};
static_assert(Parent<LastKiller>);

}  // namespace trophic::reproduction::parent
