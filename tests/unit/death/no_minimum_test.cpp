// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/minimum_predators/no_minimum.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no minimum: no predator left -> no sacrifice") {
  const HandPopulation robots{{{.species = prey}, {.species = prey}}};
  Rng rng{1, Stream::sacrifice};
  CHECK(death::minimum_predators::NoMinimum{}.sacrifices(robots.view(), rng).empty());
}
