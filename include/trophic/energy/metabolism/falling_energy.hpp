// SPDX-License-Identifier: MIT
// Energy that falls with time, shared food, and newborns that the outside completes.
#pragma once

#include <trophic/energy/metabolism/contract.hpp>

namespace trophic::energy::metabolism {

/// Rule, for an individual with energy E in a tick of length t:
///   E <- E - loss * t,   E <- E + min(there, capacity - E) in a table with a Resource
/// Founders start with `first`. A newborn to which parents gave less than `newborn` gets the rest from outside; with newborn = 0
/// it has what its parents gave. An individual starves once E <= 0.   Source: 100 at first and 5 lost a minute [peterson2026].
/// Reads: energies.   Random draws: 0.
struct FallingEnergy {
  static constexpr std::string_view name = "falling_energy";
  static constexpr std::string_view source = "not in the paper; [peterson2026]";

  struct Params {
    double first_J = 100.0;
    double newborn_J = 100.0;
    double loss_W = 5.0 / 60.0;
    double capacity_J = 100.0;
    static constexpr auto fields() {
      return std::tuple{field("first_J", &Params::first_J, at_least(0.0), "energy of founders, and of newborns without parents")
                            .read_for_newcomers(),
                        field("newborn_J", &Params::newborn_J, at_least(0.0),
                              "energy to which the outside completes a newborn; 0: it adds none")
                            .read_at_birth(),
                        field("loss_W", &Params::loss_W, at_least(0.0), "energy lost per second"),
                        field("capacity_J", &Params::capacity_J, above(0.0), "largest energy that an individual has by eating")};
    }
  };
  Params params;

  [[nodiscard]] double first_J(const Individual&, Rng&) const { return params.first_J; }
  [[nodiscard]] double grant_J(const Individual& newborn) const { return std::max(params.newborn_J - newborn.energy_J, 0.0); }
  [[nodiscard]] double upkeep_J(BodyIndex, double, const View& view) const { return params.loss_W * view.tick_s; }
  [[nodiscard]] double bite_J(BodyIndex self, std::size_t, double there_J, const View& view) const {
    return std::clamp(params.capacity_J - view.robots[self].energy_J, 0.0, there_J);
  }
  [[nodiscard]] double meal_J(BodyIndex, BodyIndex, const View&) const { return 0.0; }
  [[nodiscard]] bool starves(BodyIndex self, const View& view) const { return view.robots[self].energy_J <= 0.0; }
};
static_assert(Metabolism<FallingEnergy>);

}  // namespace trophic::energy::metabolism
