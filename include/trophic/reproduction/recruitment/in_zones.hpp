// SPDX-License-Identifier: MIT
// Births from pairs that meet in a mating zone.
#pragma once

#include <trophic/population/mating_zones.hpp>
#include <trophic/reproduction/recruitment/contract.hpp>

namespace trophic::reproduction::recruitment {

/// Rule: at the last tick of each `interval`, the individuals in a zone form pairs of one species: the oldest first, each with
/// the nearest that has no mate yet. A pair has `offspring` newborns, the first `step` away from the older parent in a random
/// direction, the second from the younger one; with step = 0, at a free place next to it. Each parent gives `cost` or, if the
/// poorer one has less, what that one has; the newborns share it. The dead are not replaced. `spare_bodies` start without an
/// individual. The rule Resource keeps the zones (MovingZones).   Source: [peterson2026], whose text gives zones, cost and
/// radius of birth; two offspring at that distance are as in its authors' code.   Reads: positions, zones, energies.   Random
/// draws: 1 per offspring if step > 0.
struct InZones {
  static constexpr std::string_view name = "in_zones";
  static constexpr std::string_view source = "not in the paper; [peterson2026]";
  using NoNewcomers = InZones;

  struct Params {
    std::size_t spare_bodies = 0;
    std::int64_t interval_ticks = 1;
    std::int64_t offspring = 2;
    double cost_J = 25.0;
    double step_m = 3.0;
    static constexpr auto fields() {
      return std::tuple{
          field("spare_bodies", &Params::spare_bodies, at_least(0), "number of bodies without an individual at the start")
              .read_at_start(),
          field("interval_ticks", &Params::interval_ticks, at_least(1), "pairs form every so many ticks"),
          field("offspring", &Params::offspring, between(1, 2), "newborns of a pair"),
          field("cost_J", &Params::cost_J, above(0.0), "energy that each parent gives"),
          field("step_m", &Params::step_m, at_least(0.0), "distance of a newborn from its parent, limited by the walls")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t spare_bodies() const { return params.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return true; }
  [[nodiscard]] std::vector<Recruit> recruits(const View& view, Rng& rng) const {
    std::vector<Recruit> births;
    if ((view.tick + 1) % params.interval_ticks != 0) return births;
    std::vector<BodyIndex> single;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.robots[body].lives() && view.robots[body].energy_J > 0.0) single.push_back(body);
    }
    std::ranges::sort(single, {}, [&](BodyIndex body) { return view.robots[body].id; });
    for (const MatingZone& zone : zones_in(view)) {
      std::vector<BodyIndex> inside;
      std::ranges::copy_if(single, std::back_inserter(inside), [&](BodyIndex one) { return is_in(zone, view.poses[one], view); });
      while (!inside.empty()) {
        const BodyIndex self = inside.front();
        inside.erase(inside.begin());
        const auto away_m = [&](BodyIndex other) {
          const bool is_kin = view.robots[other].species == view.robots[self].species;
          return is_kin ? view.distance_m(self, other) : std::numeric_limits<double>::infinity();
        };
        const auto mate = std::ranges::min_element(inside, {}, away_m);
        if (mate == inside.end() || !std::isfinite(away_m(*mate))) continue;
        add_births(births, self, *mate, view, rng);
        std::erase(single, self);
        std::erase(single, *mate);
        inside.erase(mate);
      }
    }
    return births;
  }

 private:
  void add_births(std::vector<Recruit>& births, BodyIndex older, BodyIndex younger, const View& view, Rng& rng) const {
    const double each_J = std::min({params.cost_J, view.robots[older].energy_J, view.robots[younger].energy_J});
    for (std::int64_t child = 0; child < params.offspring; ++child) {
      const BodyIndex near = child == 0 ? older : younger;
      const BodyIndex other = child == 0 ? younger : older;
      births.push_back({.species = view.robots[older].species,
                        .parents = {view.robots[near].as_ancestor(), view.robots[other].as_ancestor()},
                        .endowment_J = 2.0 * each_J / static_cast<double>(params.offspring),
                        .place = params.step_m > 0.0 ? std::optional{step_from(view.poses[near], view, rng)} : std::nullopt});
    }
  }
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
static_assert(Recruitment<InZones>);

}  // namespace trophic::reproduction::recruitment
