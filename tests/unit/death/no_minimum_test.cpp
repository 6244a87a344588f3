// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/minimum_predators/no_minimum.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no minimum_predators: nobody is given up when there is no predator left") {
  const HandPopulation robots{{{.species = prey}, {.species = prey}}};
  Rng rng{1, Stream::sacrifice};
  CHECK(death::minimum_predators::NoMinimum{}.sacrifices(robots.view(), rng).empty());
}
