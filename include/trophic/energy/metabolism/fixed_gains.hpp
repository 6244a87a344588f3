// SPDX-License-Identifier: MIT
// A fixed cost per tick and a fixed gain per meal, however much energy the victim had.
#pragma once

#include <trophic/energy/metabolism/contract.hpp>

namespace trophic::energy::metabolism {

/// Rule: a tick costs `tick`. A species that hunts nothing takes at most `gain` from its cell of the resource. A hunter gets
/// `gain` from outside at each catch, so energy is not conserved. A founder's energy is a random whole number below twice the
/// gain. An individual starves below 0. As in NetLogo's wolf sheep predation [wilensky1997]; in which a sheep gains 4 and a wolf
/// 20 (by_species). Reads: energies, the food web.   Random draws: 1 for a founder.
struct FixedGains {
  static constexpr std::string_view name = "fixed_gains";
  static constexpr std::string_view source = "not in the paper; [wilensky1997]";

  struct Params {
    double gain_J = 4.0;
    double tick_J = 1.0;
    static constexpr auto fields() {
      return std::tuple{
          field("gain_J", &Params::gain_J, at_least(0.0), "energy gained from a bite of the resource or from a catch"),
          field("tick_J", &Params::tick_J, at_least(0.0), "energy spent per tick")};
    }
  };
  Params params;

  [[nodiscard]] double first_J(const Individual&, Rng& rng) const { return std::floor(rng.uniform(0.0, 2.0 * params.gain_J)); }
  [[nodiscard]] double upkeep_J(BodyIndex, double, const View&) const { return params.tick_J; }
  [[nodiscard]] double bite_J(BodyIndex self, std::size_t, double there_J, const View& view) const {
    return view.web.hunts(view.robots[self].species) ? 0.0 : std::min(there_J, params.gain_J);
  }
  [[nodiscard]] double meal_J(BodyIndex, BodyIndex, const View&) const { return 0.0; }
  [[nodiscard]] double bonus_J(BodyIndex, BodyIndex, const View&) const { return params.gain_J; }
  [[nodiscard]] bool starves(BodyIndex self, const View& view) const { return view.robots[self].energy_J < 0.0; }
};
static_assert(Metabolism<FixedGains>);

}  // namespace trophic::energy::metabolism
