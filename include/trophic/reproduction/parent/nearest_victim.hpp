// SPDX-License-Identifier: MIT
// The prey closest to a dying predator reproduces.
#pragma once

#include <optional>
#include <string_view>
#include <trophic/params/params.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <tuple>

namespace trophic::reproduction::parent {

/// Rule: when a hunter dies, the closest individual that it could eat, if within range, is the parent of the offspring that
/// takes its body (Sec. "Reproduction": "within a certain minimum distance away from the predator"). Tags and activity do
/// not count: the paper says "any prey". The paper gives no number; an early draft used 4 m.   Reads: positions,
/// species.   Random draws: 0.
struct NearestVictim {
  static constexpr std::string_view name = "nearest_victim";
  static constexpr std::string_view source = "paper, Sec. \"Reproduction\"; silent on the range: an early draft's";

  struct Params {
    double range_m = 4.0;
    static constexpr auto fields() {
      return std::tuple{field("range_m", &Params::range_m, at_least(0.0), "the parent must be this close to the dying hunter")};
    }
  };
  Params params;

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&) const {
    const Species dying = view.robots[vacancy.body].species;
    const auto eats = [&](Species other) { return view.web.eats(dying, other); };
    const auto closest = view.closest(vacancy.body, [&](const Individual& other) { return eats(other.species); },
                                      {.within_m = params.range_m, .among = view.marks(eats)});
    if (!closest) return std::nullopt;
    return view.robots[*closest].as_ancestor();
  }
};
static_assert(Parent<NearestVictim>);

}  // namespace trophic::reproduction::parent
