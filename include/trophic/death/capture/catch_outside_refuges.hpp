// SPDX-License-Identifier: MIT
// The paper's captures, except for prey in a refuge.
#pragma once

#include <trophic/death/capture/catch_within_reach.hpp>
#include <trophic/population/outset.hpp>

namespace trophic::death::capture {

/// Rule: like CatchWithinReach, but an individual in a zone of the arena named "refuge" is not caught. Hunters may enter the zone
/// and see prey in it. Reads: zones, positions, species, activity, ages.   Random draws: 0.
struct CatchOutsideRefuges {
  static constexpr std::string_view name = "catch_outside_refuges";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::string_view zone = "refuge";

  using Params = CatchWithinReach::Params;
  Params params;

  [[nodiscard]] std::string idle(const Outset& outset) const {
    if (std::ranges::count(outset.arena.zones, zone, &Zone::name) > 0) return {};
    return std::string{name} + " protects no prey: arena " + outset.arena.name + " has no zone named " + std::string{zone};
  }
  [[nodiscard]] std::vector<Capture> captures(const View& view, Rng& rng, std::optional<Species> only = {}) const {
    std::vector<Capture> reached = CatchWithinReach{params}.captures(view, rng, only);
    std::erase_if(reached, [&](const Capture& capture) {
      return std::ranges::any_of(view.arena.zones,
                                 [&](const Zone& one) { return one.name == zone && one.holds(view.poses[capture.victim]); });
    });
    return reached;
  }
};
static_assert(CaptureRule<CatchOutsideRefuges>);

}  // namespace trophic::death::capture
