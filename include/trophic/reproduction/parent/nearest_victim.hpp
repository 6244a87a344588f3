// SPDX-License-Identifier: MIT
// The prey closest to a dying predator reproduces.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/parent/detail/nearest_prey.hpp>

namespace trophic::reproduction::parent {

/// Rule: when a hunter dies, the closest individual that it could eat, if within range, is the parent of the offspring that
/// takes its body. Tags and activity do not count: the text has "any prey" (Sec. "Reproduction"). So an inactive newborn, which
/// cannot be caught, may reproduce next to a predator; NearestActiveVictim excludes it. The paper gives no range: its text has
/// "within a certain minimum distance away from the predator", a draft's comment "within four units away from it".   Reads:
/// positions, species.   Random draws: 0.
struct NearestVictim {
  static constexpr std::string_view name = "nearest_victim";
  static constexpr std::string_view source = "paper, Sec. \"Reproduction\"; silent on activity and range";

  struct Params {
    double range_m = 4.0;
    static constexpr auto fields() {
      return std::tuple{
          field("range_m", &Params::range_m, at_least(0.0), "largest distance between the parent and the dying hunter")};
    }
  };
  Params params;

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&) const {
    return detail::nearest_prey(vacancy.body, params.range_m, false, view);
  }
};
static_assert(Parent<NearestVictim>);

}  // namespace trophic::reproduction::parent
