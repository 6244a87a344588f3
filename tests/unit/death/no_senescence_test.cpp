// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/senescence/no_senescence.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no senescence: any age -> no death") {
  HandPopulation robots{{{.species = predator}, {.species = prey}}};
  Rng rng{1, Stream::senescence};
  robots.at_tick(1'000'000);
  CHECK_FALSE(death::senescence::NoSenescence{}.dies(robots.individuals[0], robots.view(), rng));
  CHECK_FALSE(death::senescence::NoSenescence{}.dies(robots.individuals[1], robots.view(), rng));
}
