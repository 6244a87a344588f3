// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/recruitment/at_energy.hpp>
#include <trophic/reproduction/recruitment/by_mating.hpp>

using namespace trophic;
using namespace trophic::test;
using reproduction::recruitment::ByMating;

namespace {

struct OthersOfAtEnergy : reproduction::recruitment::AtEnergy {};
static_assert(reproduction::names_several_parents<ByMating> && reproduction::names_several_parents<OthersOfAtEnergy>);
static_assert(!reproduction::names_several_parents<reproduction::recruitment::AtEnergy>);

}  // namespace

TEST_CASE("by mating: both willing, rich and near -> one birth of two parents, the oldest chooses the nearest") {
  HandPopulation robots{{{.species = prey, .x_m = 0.0},
                         {.species = prey, .x_m = 1.0},
                         {.species = prey, .x_m = -0.5},
                         {.species = predator, .x_m = 0.1},
                         {.species = prey, .x_m = 1.5}}};
  for (Individual& one : robots.individuals) one.energy_J = 80.0;
  robots.individuals[2].energy_J = 60.0;
  const ByMating rule{{.spare_bodies = 2, .birth_J = 60.0, .share = 0.25, .range_m = 1.0}};
  const auto parents_of = [&](const View& view) {
    Rng rng{1, Stream::user};
    std::vector<std::vector<IndividualId>> all;
    for (const auto& birth : rule.recruits(view, rng)) {
      all.emplace_back();
      for (const Ancestor& parent : birth.parents) all.back().push_back(parent.id);
      CHECK(birth.species == prey);
      CHECK(birth.endowment_J == (birth.parents[1].id == 2 ? 30.0 : 40.0));
    }
    return all;
  };
  using Pairs = std::vector<std::vector<IndividualId>>;
  CHECK(parents_of(robots.view()) == Pairs{{0, 2}, {1, 4}});
  const char* const mate = &trophic::detail::act_key<control::acts::Mate>;
  const std::vector<double> unwilling{1.0, 1.0, 0.0, 1.0, 1.0};
  View view = robots.view();
  view.acts = {.acts = {&mate, 1}, .values = unwilling};
  CHECK(parents_of(view) == Pairs{{0, 1}});
  robots.individuals[1].energy_J = 59.0;
  CHECK(parents_of(robots.view()) == Pairs{{0, 2}});
  robots.individuals[0].active = false;
  CHECK(parents_of(robots.view()).empty());
  CHECK(rule.spare_bodies() == 2);
  CHECK(rule.leaves_spare({.body = 0, .cause = Cause::caught}, robots.view()));
}
