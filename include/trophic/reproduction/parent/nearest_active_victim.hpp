// SPDX-License-Identifier: MIT
// The active prey closest to a dying predator reproduces.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/parent/detail/nearest_prey.hpp>

namespace trophic::reproduction::parent {

/// Rule: when a hunter dies, the closest active individual that it could eat, if within range, is the parent of the offspring
/// that takes its body (Sec. "Reproduction"). The paper leaves activity and range open.
///
/// Activity: the text says "any prey", but calls the newborn's state "a state of inactivity" (Sec. "Prey Death"). A draft's
/// comment denies that a newborn "can immediately interact with other robots" (Sec. "Birth"). NearestVictim is the alternative
/// reading, in which a newborn that cannot be caught may reproduce next to a predator.
///
/// Range: the text says "within a certain minimum distance away from the predator", a draft's comment "within four units away
/// from it". Without an active prey in range the genome is random, so a short range makes inherited prey rarer than the 2/3 that
/// the text takes as its baseline. At 12 m, 98 % of the births that should inherit have a parent (26 % at 4 m; kinematic).
///
/// Reads: positions, species, activity.   Random draws: 0.
struct NearestActiveVictim {
  static constexpr std::string_view name = "nearest_active_victim";
  static constexpr std::string_view source = "paper, Sec. \"Reproduction\"; silent on activity and range";

  struct Params {
    double range_m = 12.0;
    static constexpr auto fields() {
      return std::tuple{
          field("range_m", &Params::range_m, at_least(0.0), "largest distance between the parent and the dying hunter")};
    }
  };
  Params params;

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&) const {
    return detail::nearest_prey(vacancy.body, params.range_m, true, view);
  }
};
static_assert(Parent<NearestActiveVictim>);

}  // namespace trophic::reproduction::parent
