// SPDX-License-Identifier: MIT
// Grazers eat each food by their heritable diet.
#pragma once

#include <trophic/energy/metabolism/grazing_and_hunting.hpp>
#include <trophic/reproduction/traits/list.hpp>

namespace trophic::energy::metabolism {

/// The heritable trait of GrazingByDiet: the place of an individual's diet between the first food, 0, and the last one, 1.
struct Diet {
  static constexpr std::string_view name = "diet";
  static constexpr double first = 0.5, least = 0.0, most = 1.0, sd = 0.1;
};

/// Rule: like GrazingAndHunting, but a grazer with Diet d takes food i of n at the rate bite * s and gains s^(tradeoff - 1) of
/// it; the rest is destroyed:
///   s = max(0, 1 - |d (n - 1) - i|)
/// so with two foods s is 1 - d and d. Above 1, `tradeoff` makes generalists gain less than specialists, as in a concave fitness
/// set of [levins1962]. The trait belongs to an individual; by_species of the Traits, with sd 0,
/// makes it one of a species. `Traits` is the table's rule for traits, which has Diet. All parameters are free.
/// Reads: as GrazingAndHunting, the traits, the number of foods.   Random draws: as GrazingAndHunting.
template <class Traits = reproduction::traits::List<Diet>>
struct GrazingByDiet {
  static constexpr std::string_view name = "grazing_by_diet";
  static constexpr std::string_view source = "not in the paper; after [yaeger1994], [levins1962]";
  using ReadsTraits = Traits;
  using ReadsDiets = GrazingByDiet;  ///< without several foods a run has a remark

  struct Params {
    GrazingAndHunting::Params energy{};
    double tradeoff = 2.0;
    static constexpr auto fields() {
      return std::tuple{field("energy", &Params::energy), field("tradeoff", &Params::tradeoff, at_least(1.0),
                                                                "exponent of a food's share in the diet; 1: no trade-off")};
    }
  };
  Params params;

  [[nodiscard]] std::string_view why_no_effect(std::string_view number, const FoodWeb& web, OneSpecies species) const {
    constexpr std::string_view of_energy = "energy.";
    if (number.starts_with(of_energy)) return asked().why_no_effect(number.substr(of_energy.size()), web, species);
    return species && web.hunts(*species) ? "for a species that hunts" : "";
  }

  [[nodiscard]] double first_J(const Individual& newborn, Rng& rng) const { return asked().first_J(newborn, rng); }
  [[nodiscard]] double upkeep_J(BodyIndex self, double walked_m, const View& view) const {
    return asked().upkeep_J(self, walked_m, view);
  }
  [[nodiscard]] double bite_J(BodyIndex self, std::size_t food, double there_J, const View& view) const {
    if (view.web.hunts(view.robots[self].species)) return 0.0;
    const double share = share_of(self, food, view);
    GrazingAndHunting grazing = asked();
    grazing.params.bite_W *= std::pow(share, params.tradeoff);
    return grazing.bite_J(self, food, there_J * efficiency(share), view);
  }
  [[nodiscard]] double waste_J(BodyIndex self, std::size_t food, double bite_J, const View& view) const {
    return bite_J > 0.0 ? bite_J / efficiency(share_of(self, food, view)) - bite_J : 0.0;
  }
  [[nodiscard]] double meal_J(BodyIndex hunter, BodyIndex victim, const View& view) const {
    return asked().meal_J(hunter, victim, view);
  }
  [[nodiscard]] bool starves(BodyIndex self, const View& view) const { return asked().starves(self, view); }
  [[nodiscard]] double capacity_J() const { return params.energy.capacity_J; }

 private:
  [[nodiscard]] GrazingAndHunting asked() const { return GrazingAndHunting{params.energy}; }
  [[nodiscard]] static double share_of(BodyIndex self, std::size_t food, const View& view) {
    const double last = std::max(static_cast<double>(view.foods.size()), 1.0) - 1.0;
    return std::max(0.0, 1.0 - std::abs(view.trait<Diet>(self) * last - static_cast<double>(food)));
  }
  [[nodiscard]] double efficiency(double share) const { return std::pow(share, params.tradeoff - 1.0); }
};
static_assert(Metabolism<GrazingByDiet<>>);

}  // namespace trophic::energy::metabolism
