// SPDX-License-Identifier: MIT
// Whether a newborn is away from its hunters; two activation rules share this.
#pragma once

#include <cmath>
#include <trophic/params/params.hpp>
#include <trophic/population/outset.hpp>
#include <trophic/population/view.hpp>

namespace trophic::death::activation::detail {

struct SafeDistance {
  double distance_m = 5.0;
  static constexpr auto fields() {
    return std::tuple{
        field("distance_m", &SafeDistance::distance_m, at_least(0.0), "a newborn activates farther than this from every hunter")};
  }
};

/// Returns whether the closest individual that eats the species in `body`, whatever its tag, is farther away than the distance.
[[nodiscard]] inline bool away_from_hunters(const SafeDistance& safe, BodyIndex body, const View& view) {
  const Species own = view.robots[body].species;
  const auto eats = [&](Species other) { return view.web.eats(other, own); };
  return !view.closest(body, [&](const Individual& other) { return eats(other.species); },
                       {.within_m = safe.distance_m, .among = view.marks(eats)});
}

/// A sentence if no two places of the arena are this far apart (Outset).
[[nodiscard]] inline std::string never_away(const SafeDistance& safe, const Outset& outset) {
  if (safe.distance_m < outset.diagonal_m() || outset.web.links().empty()) return {};
  return "distance_m = " + number_text(safe.distance_m) + ": no newborn of a hunted species ever becomes active, because arena " +
         outset.arena.name + " has a diagonal of " + number_text(std::round(10.0 * outset.diagonal_m()) / 10.0) + " m";
}

}  // namespace trophic::death::activation::detail
