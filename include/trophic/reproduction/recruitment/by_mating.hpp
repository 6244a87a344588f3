// SPDX-License-Identifier: MIT
// Births from two parents that both choose to mate.
#pragma once

#include <trophic/control/acts/list.hpp>
#include <trophic/control/acts/mate.hpp>
#include <trophic/reproduction/recruitment/contract.hpp>

namespace trophic::reproduction::recruitment {

/// Rule: two active individuals of a species that both chose to mate, have at least `birth` energy each and are at most `range`
/// apart have an offspring next to the older one. Each gives the `share` of the poorer one's energy. The oldest chooses first and
/// takes the nearest; each mates at most once a tick. The dead are not replaced. `spare_bodies` start without an individual. All
/// parameters are free.   Reads: the act Mate, positions, energies, activity.   Random draws: 0.
struct ByMating {
  static constexpr std::string_view name = "by_mating";
  static constexpr std::string_view source = "not in the paper; as in Polyworld [yaeger1994]";
  using ReadsActs = control::acts::List<control::acts::Mate>;

  struct Params {
    std::size_t spare_bodies = 0;
    double birth_J = 60.0;
    double share = 0.3;
    double range_m = 3.0;
    static constexpr auto fields() {
      return std::tuple{
          field("spare_bodies", &Params::spare_bodies, at_least(0), "number of bodies without an individual at the start")
              .read_at_start(),
          field("birth_J", &Params::birth_J, at_least(0.0), "energy that each parent needs"),
          field("share", &Params::share, between(0.0, 1.0), "share of the poorer parent's energy that each parent gives"),
          field("range_m", &Params::range_m, at_least(0.0), "largest distance between the parents")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t spare_bodies() const { return params.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return true; }
  [[nodiscard]] std::vector<Recruit> recruits(const View& view, Rng&) const {
    std::vector<BodyIndex> willing;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Individual& one = view.robots[body];
      if (one.lives() && one.active && view.act<control::acts::Mate>(body) && one.energy_J >= params.birth_J) {
        willing.push_back(body);
      }
    }
    std::ranges::sort(willing, {}, [&](BodyIndex body) { return view.robots[body].id; });
    std::vector<Recruit> births;
    while (!willing.empty()) {
      const BodyIndex self = willing.front();
      const Individual& one = view.robots[self];
      willing.erase(willing.begin());
      const auto away_m = [&](BodyIndex other) {
        return view.robots[other].species == one.species ? view.distance_m(self, other) : 2.0 * params.range_m + 1.0;
      };
      const auto mate = std::ranges::min_element(willing, {}, away_m);
      if (mate == willing.end() || !(away_m(*mate) <= params.range_m)) continue;
      const Individual& other = view.robots[*mate];
      births.push_back({.species = one.species,
                        .parents = {one.as_ancestor(), other.as_ancestor()},
                        .endowment_J = 2.0 * params.share * std::min(one.energy_J, other.energy_J)});
      willing.erase(mate);
    }
    return births;
  }
};
static_assert(Recruitment<ByMating>);

}  // namespace trophic::reproduction::recruitment
