// SPDX-License-Identifier: MIT
// The hunter that catches reproduces.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::reproduction::parent {

/// Rule: the hunter that catches is the parent of the offspring that takes the caught body (Sec. "Reproduction"). Reads:
/// killer.   Random draws: 0.
struct Killer {
  static constexpr std::string_view name = "killer";
  static constexpr std::string_view source = "paper, Sec. \"Reproduction\"";
  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&) const {
    if (!vacancy.killer) return std::nullopt;
    return view.robots[*vacancy.killer].as_ancestor();
  }
};
static_assert(Parent<Killer>);

}  // namespace trophic::reproduction::parent
