// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/floor/no_floor.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no floor: last prey -> may die") {
  const HandPopulation robots{{{.species = prey}, {.species = predator}}};
  CHECK(death::floor::NoFloor{}.may_die(prey, robots.view()));
}
