// SPDX-License-Identifier: MIT
// The race of pond_race with a second trait, sight, and costs that grow with the square of each.
#pragma once

#include <trophic/perception/visibility/contract.hpp>
#include <trophic/worlds/pond_race.hpp>

namespace trophic::race {

/// The distance up to which an individual perceives others.
struct Sight {
  static constexpr std::string_view name = "sight_m";
  static constexpr double first = 15.0, least = 1.0, most = 60.0, sd = 0.8;
};
using PaceAndSight = reproduction::traits::List<control::pace::WalkingPace, Sight>;

/// Rule: like SameTag, but up to the distance that self inherits.   Source: not in the paper.   Reads: positions, both tags,
/// other's activity, the trait sight_m.   Random draws: 0.
struct InheritedSight {
  static constexpr std::string_view name = "inherited_sight";
  static constexpr std::string_view source = "not in the paper";
  using ReadsTraits = PaceAndSight;

  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view, Rng&) const {
    const Individual& seen = view.robots[other];
    return view.robots[self].tag == seen.tag && seen.active && view.distance_m(self, other) <= view.trait<Sight>(self);
  }
};
static_assert(perception::Visibility<InheritedSight>);

/// Rule: like GrazingAndHunting, but at pace p and sight s
///   E <- E - (resting + sight * s^2 + walking * p * distance / t) * t
/// so the power of walking grows with the square of pace, as the distance grows with pace. At p = 1 and sight = 0 it is that
/// rule. Not in the paper; all parameters are free.   Reads: as GrazingAndHunting, both traits.   Random draws: as
/// GrazingAndHunting.
struct SquareCosts {
  using Budget = energy::metabolism::GrazingAndHunting;
  static constexpr std::string_view name = "square_costs";
  static constexpr std::string_view source = "not in the paper";
  using ReadsTraits = PaceAndSight;

  struct Params {
    Budget::Params budget{};
    double sight_W_per_m2 = 5e-5;
    static constexpr auto fields() {
      return std::tuple{field("budget", &Params::budget), field("sight_W_per_m2", &Params::sight_W_per_m2, at_least(0.0),
                                                                "power of sight per square metre of s^2")};
    }
  };
  Params params;

  [[nodiscard]] double first_J(const Individual& newborn, Rng& rng) const { return Budget{params.budget}.first_J(newborn, rng); }
  [[nodiscard]] double upkeep_J(BodyIndex self, double walked_m, const View& view) const {
    const double sight_m = view.trait<Sight>(self);
    return Budget{params.budget}.upkeep_J(self, view.trait<control::pace::WalkingPace>(self) * walked_m, view) +
           params.sight_W_per_m2 * sight_m * sight_m * view.tick_s;
  }
  [[nodiscard]] double bite_J(BodyIndex self, double there_J, const View& view) const {
    return Budget{params.budget}.bite_J(self, there_J, view);
  }
  [[nodiscard]] double meal_J(BodyIndex hunter, BodyIndex victim, const View& view) const {
    return Budget{params.budget}.meal_J(hunter, victim, view);
  }
  [[nodiscard]] bool starves(BodyIndex self, const View& view) const { return Budget{params.budget}.starves(self, view); }
};
static_assert(energy::Metabolism<SquareCosts>);

inline constexpr auto with_budgets_of_the_race = [](auto& params) {
  const auto of_race = worlds::PondRace::params().metabolism;
  params.metabolism.template get<0>().budget = of_race.template get<0>();
  params.metabolism.template get<1>().budget = of_race.template get<1>();
  params.metabolism.template get<1>().budget.efficiency = 0.25;
};

/// Rules: like PondRace, but sight is inherited too, and the power of walking and seeing grows with the square of pace and sight.
/// A predator gets 0.25 of the energy of its prey, as one that sees no farther than 15 m finds fewer.   Source: not in the
/// literature as such.
using PondSight = named<with_params<with_metabolism<with_visibility<with_traits<worlds::PondRace, PaceAndSight>, InheritedSight>,
                                                    rules::by_species<SquareCosts>>,
                                    with_budgets_of_the_race>,
                        "pond_sight">;

}  // namespace trophic::race
