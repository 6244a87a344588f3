// SPDX-License-Identifier: MIT
// The paper's captures: every active prey within reach of a predator is caught.
#pragma once

#include <trophic/death/capture/contract.hpp>

namespace trophic::death::capture {

/// Rule: if a hunter and an active victim are within reach of each other, the victim is caught, whatever their tags (Sec. "Prey
/// Death": one unit). A victim is caught by its closest hunter; these pairs are processed by increasing distance, then hunter,
/// then victim. A hunter may catch several victims in a tick (the paper sets no limit), but none after it has been caught itself,
/// which can happen in a food chain. Individuals born in this tick hunt from the next tick on. Hunters younger than min_age do
/// not hunt (0 in the paper). Reads: positions, species, activity, ages.   Random draws: 0.
struct CatchWithinReach {
  static constexpr std::string_view name = "catch_within_reach";
  static constexpr std::string_view source = "paper, Sec. \"Prey Death\"";

  struct Params {
    double reach_m = 1.0;
    double min_age_s = 0.0;
    static constexpr auto fields() {
      return std::tuple{field("reach_m", &Params::reach_m, above(0.0), "distance within which a victim is caught"),
                        field("min_age_s", &Params::min_age_s, at_least(0.0), "age below which hunters do not hunt")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<Capture> captures(const View& view, Rng&, std::optional<Species> only = {}) const {
    struct Reached {
      double distance_m;
      Capture capture;
    };
    std::vector<Reached> reached;
    for (BodyIndex victim = 0; victim < view.robots.size(); ++victim) {
      const Individual& prey = view.robots[victim];
      if (!prey.active) continue;
      const auto eats = [&](Species other) { return other == only.value_or(other) && view.web.eats(other, prey.species); };
      const auto hunter = view.closest(
          victim, [&](const Individual& other) { return eats(other.species) && view.passed(other.age_from_s, params.min_age_s); },
          {.within_m = params.reach_m, .among = view.marks(eats)});
      if (hunter) reached.push_back({view.distance_m(*hunter, victim), {*hunter, victim}});
    }
    std::ranges::sort(reached, {}, [](const Reached& r) { return std::tuple{r.distance_m, r.capture.hunter, r.capture.victim}; });
    std::vector<Capture> result;
    for (const Reached& r : reached) result.push_back(r.capture);
    return result;
  }
};
static_assert(CaptureRule<CatchWithinReach>);

}  // namespace trophic::death::capture
