// SPDX-License-Identifier: MIT
// The last few active prey are protected.
#pragma once

#include <trophic/death/floor/contract.hpp>
#include <trophic/death/floor/detail/spares_all.hpp>

namespace trophic::death::floor {

/// Rule: no member of a hunted species is caught or sacrificed unless more than `floor` active members are left. The paper is
/// silent: "no prey can die if there are only 7 prey in the population" (Sec. "Prey Death") does not settle whether an inactive
/// newborn counts. VictimFloor, which counts it, is the alternative reading.   Reads: species, activity.   Random draws: 0.
struct ActiveVictimFloor {
  static constexpr std::string_view name = "active_victim_floor";
  static constexpr std::string_view source = "paper: silent; a reading of Sec. \"Prey Death\"";

  struct Params {
    std::size_t floor = 7;
    static constexpr auto fields() {
      return std::tuple{
          field("floor", &Params::floor, at_least(0), "minimum number of active members that catches and sacrifices leave")};
    }
  };
  Params params;

  [[nodiscard]] std::string idle(const Outset& outset) const { return detail::spares_all(params.floor, outset); }
  [[nodiscard]] bool may_die(Species species, const View& view) const {
    const auto counts = [&](const Individual& one) { return one.species == species && one.active; };
    return static_cast<std::size_t>(std::ranges::count_if(view.robots, counts)) > params.floor;
  }
};
static_assert(Floor<ActiveVictimFloor>);

}  // namespace trophic::death::floor
