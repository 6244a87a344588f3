// SPDX-License-Identifier: MIT
// The prey that the dying predator last perceived as closest reproduces, however long ago that was.
#pragma once

#include <optional>
#include <string_view>
#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::reproduction::parent {

/// Rule (released code): the parent is the last individual that the dying hunter's body perceived as closest among those it
/// eats, at any distance, dead or alive. The memory is renewed only when another body becomes the closest: somebody reborn in the
/// remembered body is not noticed. It outlives births in the hunter's body and is cleared only by a catch.   Reads: body memory.
/// Random draws: 0.
struct LastSeenVictim {
  static constexpr std::string_view name = "last_seen_victim";
  static constexpr std::string_view source = "released code";
  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&) const {
    return view.robots[vacancy.body].memory.last_seen_victim;
  }
};
static_assert(Parent<LastSeenVictim>);

}  // namespace trophic::reproduction::parent
