// SPDX-License-Identifier: MIT
// The last few prey are protected.
#pragma once

#include <trophic/death/floor/contract.hpp>
#include <trophic/death/floor/detail/spares_all.hpp>

namespace trophic::death::floor {

/// Rule: no member of a hunted species is caught or sacrificed while only `floor` members are left, including inactive newborns
/// (Sec. "Prey Death": 7; in the released code catches stop below 7, so its floor is 6). The paper is silent on whether inactive
/// newborns count; ActiveVictimFloor is the alternative reading.   Reads: species count.   Random draws: 0.
struct VictimFloor {
  static constexpr std::string_view name = "victim_floor";
  static constexpr std::string_view source = "paper, Sec. \"Prey Death\"";

  struct Params {
    std::size_t floor = 7;
    static constexpr auto fields() {
      return std::tuple{field("floor", &Params::floor, at_least(0),
                              "minimum number of members of a hunted species that catches and sacrifices leave")};
    }
  };
  Params params;

  [[nodiscard]] std::string idle(const Outset& outset) const { return detail::spares_all(params.floor, outset); }
  [[nodiscard]] bool may_die(Species species, const View& view) const { return view.count(species) > params.floor; }
};
static_assert(Floor<VictimFloor>);

}  // namespace trophic::death::floor
