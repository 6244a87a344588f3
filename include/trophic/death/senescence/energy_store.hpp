// SPDX-License-Identifier: MIT
// Death by exhaustion of an energy store.
#pragma once

#include <trophic/death/senescence/contract.hpp>

namespace trophic::death::senescence {

/// Rule: an individual dies once its energy store is empty. Living and walking drain it, a catch fills it:
///   E <- min(capacity, E + meal) at each catch,
///   E <- min(capacity, E - walking * distance - (resting - grazing) * tick) at each tick, grazing only for species that do not
/// hunt.
/// A newborn starts with `start`, independent of its parent and its body. An alternative to the paper's hunger, which counts
/// ticks equally for robots that walk and robots that wait (Sec. "Predator Death"); energy balance as in Polyworld
/// [yaeger1994]. All its parameters are free. Reads: its own state, the distance walked, catches.   Random draws: 0.
struct EnergyStore {
  static constexpr std::string_view name = "energy_store";
  static constexpr std::string_view source = "not in the paper; after [yaeger1994]";

  struct Params {
    double start_J = 100.0;
    double capacity_J = 200.0;
    double walking_J_per_m = 5.0;
    double resting_W = 0.2;
    double grazing_W = 0.3;
    double meal_J = 80.0;
    static constexpr auto fields() {
      return std::tuple{field("start_J", &Params::start_J, above(0.0), "a newborn's energy"),
                        field("capacity_J", &Params::capacity_J, above(0.0), "upper limit of the store"),
                        field("walking_J_per_m", &Params::walking_J_per_m, at_least(0.0), "energy per metre walked"),
                        field("resting_W", &Params::resting_W, at_least(0.0), "power at rest and while walking"),
                        field("grazing_W", &Params::grazing_W, at_least(0.0), "power gained by species that do not hunt"),
                        field("meal_J", &Params::meal_J, at_least(0.0), "energy per catch")};
    }
  };
  Params params;

  /// Per individual.
  struct State {
    double energy_J = 0.0;
    static constexpr auto fields() { return std::tuple{field("energy_J", &State::energy_J)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const {
    return {.energy_J = std::min(params.start_J, params.capacity_J)};
  }

  void on_walk(State& own, BodyIndex self, double distance_m, const View& view) const {
    const double grazing_W = view.web.hunts(view.robots[self].species) ? 0.0 : params.grazing_W;
    fill(own, (grazing_W - params.resting_W) * view.tick_s - params.walking_J_per_m * distance_m);
  }
  void on_catch(State& own, BodyIndex, BodyIndex, const View&) const { fill(own, params.meal_J); }

  [[nodiscard]] bool dies(const Individual&, const View&, Rng&, const State& own) const { return own.energy_J <= 0.0; }

 private:
  void fill(State& own, double energy_J) const { own.energy_J = std::min(own.energy_J + energy_J, params.capacity_J); }
};
static_assert(Senescence<EnergyStore>);

}  // namespace trophic::death::senescence
