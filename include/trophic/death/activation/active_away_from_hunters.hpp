// SPDX-License-Identifier: MIT
// Newborn prey stay out of the game until they are away from every predator.
#pragma once

#include <string_view>
#include <trophic/death/activation/contract.hpp>
#include <trophic/params/params.hpp>
#include <tuple>

namespace trophic::death::activation {

/// Rule: an inactive newborn becomes active once it is farther than distance from everybody that eats its species, whatever
/// the tags (Sec. "Prey Death", against "spawn-killing"; the paper gives no number, the released code 5 m). In the released
/// code its age counts from then. Reads: positions, species.   Random draws: 0.
struct ActiveAwayFromHunters {
  static constexpr std::string_view name = "active_away_from_hunters";

  struct Params {
    double distance_m = 5.0;
    bool restarts_age = false;
    static constexpr auto fields() {
      return std::tuple{field("distance_m", &Params::distance_m, at_least(0.0), "farther than this from every hunter"),
                        field("restarts_age", &Params::restarts_age, "age counts from activation, not from birth")};
    }
  };
  Params params;

  [[nodiscard]] bool activates(BodyIndex body, const View& view) const {
    const Species own = view.robots[body].species;
    const auto hunter = view.closest(body, [&](const Individual& other) { return view.web.eats(other.species, own); });
    return !hunter || view.distance_m(body, *hunter) > params.distance_m;
  }
  [[nodiscard]] bool restarts_age() const { return params.restarts_age; }
};
static_assert(Activation<ActiveAwayFromHunters>);

}  // namespace trophic::death::activation
