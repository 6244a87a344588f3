// SPDX-License-Identifier: MIT
// Grazers live on the resource, hunters on what they catch, and both pay for living and walking.
#pragma once

#include <trophic/control/acts/eat.hpp>
#include <trophic/energy/metabolism/contract.hpp>

namespace trophic::energy::metabolism {

/// Rule, for an individual with energy E in a tick of length t:
///   E <- E - (resting + walking * distance / t) * t
///   E <- E + min(bite * t, there, capacity - E) of each food, for a species that hunts nothing, in a table with a Resource; in
///   one with the act Eat only if its brain chose to eat
///   E <- E + min(efficiency * victim's E, capacity - E) at a catch
/// An individual starves once E <= 0. Founders and newcomers start with `first`. The energy balance follows Polyworld
/// [yaeger1994]. All parameters are free.   Reads: energies, the distance walked, the food web, the act Eat.   Random draws: 1
/// for a founder if `first` has a spread.
struct GrazingAndHunting {
  static constexpr std::string_view name = "grazing_and_hunting";
  static constexpr std::string_view source = "not in the paper; after [yaeger1994]";

  struct Params {
    double first_J = 50.0;
    double spread = 0.0;
    double capacity_J = 200.0;
    double resting_W = 0.2;
    double walking_J_per_m = 5.0;
    double bite_W = 1.0;
    double efficiency = 1.0;
    static constexpr auto fields() {
      return std::tuple{
          field("first_J", &Params::first_J, at_least(0.0), "mean energy of founders and newcomers").read_for_newcomers(),
          field("spread", &Params::spread, between(0.0, 1.0), "their energy is uniform in first_J * (1 -+ spread)")
              .read_for_newcomers(),
          field("capacity_J", &Params::capacity_J, above(0.0), "largest energy of an individual"),
          field("resting_W", &Params::resting_W, at_least(0.0), "power at rest and while walking"),
          field("walking_J_per_m", &Params::walking_J_per_m, at_least(0.0), "energy per metre walked"),
          field("bite_W", &Params::bite_W, at_least(0.0), "largest rate at which a grazer takes energy from the resource"),
          field("efficiency", &Params::efficiency, between(0.0, 1.0), "share of the victim's energy that the hunter gets")};
    }
  };
  Params params;

  [[nodiscard]] std::string_view why_no_effect(std::string_view number, const FoodWeb& web, OneSpecies species) const {
    if (!species) return "";
    if (number == "efficiency" && !web.hunts(*species)) return "for a species that hunts nothing";
    return number == "bite_W" && web.hunts(*species) ? "for a species that hunts" : "";
  }

  [[nodiscard]] double first_J(const Individual&, Rng& rng) const {
    const double first_J = params.first_J * (params.spread > 0.0 ? 1.0 + rng.uniform(-params.spread, params.spread) : 1.0);
    return std::min(first_J, params.capacity_J);
  }
  [[nodiscard]] double upkeep_J(BodyIndex, double walked_m, const View& view) const {
    return params.resting_W * view.tick_s + params.walking_J_per_m * walked_m;
  }
  [[nodiscard]] double bite_J(BodyIndex self, std::size_t, double there_J, const View& view) const {
    if (view.web.hunts(view.robots[self].species) || !view.act<control::acts::Eat>(self)) return 0.0;
    return std::min({params.bite_W * view.tick_s, there_J, room_J(view.robots[self])});
  }
  [[nodiscard]] double meal_J(BodyIndex hunter, BodyIndex victim, const View& view) const {
    return std::min(params.efficiency * std::max(view.robots[victim].energy_J, 0.0), room_J(view.robots[hunter]));
  }
  [[nodiscard]] bool starves(BodyIndex self, const View& view) const { return view.robots[self].energy_J <= 0.0; }
  [[nodiscard]] double capacity_J() const { return params.capacity_J; }

 private:
  [[nodiscard]] double room_J(const Individual& self) const { return std::max(params.capacity_J - self.energy_J, 0.0); }
};
static_assert(Metabolism<GrazingAndHunting>);

}  // namespace trophic::energy::metabolism
