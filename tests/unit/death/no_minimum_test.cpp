// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/rescue/no_rescue.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no rescue: nobody is given up when there is no predator left") {
  const HandPopulation robots{{{.species = prey}, {.species = prey}}};
  Rng rng{1, Stream::sacrifice};
  CHECK(death::rescue::NoRescue{}.sacrifices(robots.view(), rng).empty());
}
