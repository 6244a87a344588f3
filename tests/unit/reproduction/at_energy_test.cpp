// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/recruitment/at_energy.hpp>

using namespace trophic;
using namespace trophic::test;
using reproduction::recruitment::AtEnergy;

TEST_CASE("at energy: active with enough -> one birth, a share of the energy handed over") {
  HandPopulation robots{{{.species = prey}, {.species = predator}, {.species = prey, .active = false}, {.species = prey}}};
  robots.individuals[0].energy_J = 60.0;
  robots.individuals[1].energy_J = 90.0;
  robots.individuals[2].energy_J = 90.0;
  robots.individuals[3].energy_J = 59.9;
  const AtEnergy rule{{.spare_bodies = 4, .birth_J = 60.0, .share = 0.25}};
  Rng rng{1, Stream::user};
  const auto births = rule.recruits(robots.view(), rng);
  REQUIRE(births.size() == 2);
  CHECK(births[0].species == prey);
  CHECK(births[0].parents == std::vector{robots.individuals[0].as_ancestor()});
  CHECK(births[0].endowment_J == 15.0);
  CHECK(births[1].species == predator);
  CHECK(births[1].endowment_J == 22.5);
  CHECK(rule.spare_bodies() == 4);
  CHECK(rule.leaves_spare({.body = 0, .cause = Cause::caught}, robots.view()));
}

TEST_CASE("at energy: the inactive have enough -> a birth only if not only the active reproduce") {
  HandPopulation robots{{{.species = prey, .active = false}}};
  robots.individuals[0].energy_J = 90.0;
  Rng rng{1, Stream::user};
  CHECK(AtEnergy{{.birth_J = 60.0}}.recruits(robots.view(), rng).empty());
  CHECK(AtEnergy{{.birth_J = 60.0, .only_active = false}}.recruits(robots.view(), rng).size() == 1);
}
