// SPDX-License-Identifier: MIT
// A species may die out.
#pragma once

#include <trophic/death/floor/contract.hpp>

namespace trophic::death::floor {

/// Rule: any individual may be caught or sacrificed, even the last member of its species.   Reads: nothing.   Random draws: 0.
struct NoFloor {
  static constexpr std::string_view name = "no_floor";
  static constexpr std::string_view source = "control";
  [[nodiscard]] bool may_die(Species, const View&) const { return true; }
};
static_assert(Floor<NoFloor>);

}  // namespace trophic::death::floor
