// SPDX-License-Identifier: MIT
// Births by chance.
#pragma once

#include <trophic/reproduction/recruitment/contract.hpp>

namespace trophic::reproduction::recruitment {

/// Rule: at each tick after the first each individual has an offspring with probability `chance`, `step` away in a random
/// direction, and gives it the `share` of its energy. The dead are not replaced; `spare_bodies` start without an individual. This
/// rule is for worlds of points, which may overlap, as in NetLogo's wolf sheep predation [wilensky1997]. All parameters are free.
/// Reads: energies, positions.   Random draws: 1 per individual in the order of births, and 1 per offspring.
struct ByChance {
  static constexpr std::string_view name = "by_chance";
  static constexpr std::string_view source = "not in the paper; [wilensky1997]";
  using NamesOneParent = ByChance;

  struct Params {
    std::size_t spare_bodies = 0;
    double chance = 0.05;
    double share = 0.5;
    double step_m = 1.0;
    static constexpr auto fields() {
      return std::tuple{
          field("spare_bodies", &Params::spare_bodies, at_least(0), "number of bodies without an individual at the start")
              .read_at_start(),
          field("chance", &Params::chance, between(0.0, 1.0), "probability of a birth at each tick"),
          field("share", &Params::share, between(0.0, 1.0), "share of its energy that a parent gives to its offspring"),
          field("step_m", &Params::step_m, at_least(0.0), "distance of the newborn from its parent, limited by the walls")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t spare_bodies() const { return params.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return true; }
  [[nodiscard]] std::vector<Recruit> recruits(const View& view, Rng& rng) const {
    std::vector<BodyIndex> parents;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.robots[body].lives()) parents.push_back(body);
    }
    std::ranges::sort(parents, {}, [&](BodyIndex body) { return view.robots[body].id; });
    std::vector<Recruit> births;
    for (const BodyIndex body : parents) {
      const Individual& one = view.robots[body];
      if (!rng.chance(params.chance)) continue;
      births.push_back({.species = one.species,
                        .parents = {one.as_ancestor()},
                        .endowment_J = params.share * std::max(one.energy_J, 0.0),
                        .place = step_from(view.poses[body], view, rng)});
    }
    return births;
  }

 private:
  [[nodiscard]] GroundPose step_from(GroundPose place, const View& view, Rng& rng) const {
    place.heading_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
    const auto within = [&](double at_m) {
      return std::clamp(view.space.shortest(at_m), -view.arena.half_side_m, view.arena.half_side_m);
    };
    place.x_m = within(place.x_m + params.step_m * std::cos(place.heading_rad));
    place.y_m = within(place.y_m + params.step_m * std::sin(place.heading_rad));
    return place;
  }
};
static_assert(Recruitment<ByChance>);

}  // namespace trophic::reproduction::recruitment
