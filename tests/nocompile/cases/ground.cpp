// SPDX-License-Identifier: MIT
// Rules of energy with all hooks, and a trait.
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/energy/metabolism/grazing_and_hunting.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/rules/paper.hpp>

struct Ground {
  static constexpr std::string_view name = "ground";
  trophic::ResourceField start(const trophic::Arena& arena, trophic::Rng&) const { return {arena, 4}; }
  void grow(trophic::ResourceField&, const trophic::View&, trophic::Rng&) const {}
  void on_bite(trophic::ResourceField& field, std::size_t cell, double, trophic::BodyIndex, const trophic::View&) const {
    field.food_J(cell) = 0.0;
  }
  void on_death(trophic::ResourceField& field, const trophic::Vacancy& death, double, const trophic::View&) const {
    field.food_J(death.body % field.cells()) = 1.0;
  }
};

struct Prizes : trophic::energy::metabolism::GrazingAndHunting {
  static constexpr std::string_view name = "prizes";
  double bonus_J(trophic::BodyIndex, trophic::BodyIndex, const trophic::View&) const { return 1.0; }
};

struct Sight {
  static constexpr std::string_view name = "sight_m";
  static constexpr double first = 8.0, least = 1.0, most = 12.0, sd = 0.5;
};

using Traits = trophic::reproduction::traits::List<Sight>;

struct AsFarAsItSees {
  static constexpr std::string_view name = "as_far_as_it_sees";
  using ReadsTraits = Traits;
  bool perceives(trophic::BodyIndex self, trophic::BodyIndex other, const trophic::View& view, trophic::Rng&) const {
    return view.robots[other].active && view.distance_m(self, other) <= view.trait<Sight>(self);
  }
};

int main() {
  using Living = trophic::with_resource<trophic::with_metabolism<trophic::rules::Paper, Prizes>, Ground>;
  using Rules = trophic::with_traits<trophic::with_visibility<Living, AsFarAsItSees>, Traits>;
  trophic::Ecology<Rules> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
