// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <support/hand_population.hpp>
#include <trophic/death/floor/victim_floor.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using death::floor::VictimFloor;

TEST_CASE("victim floor: 7 left, inactive newborn included -> none may die") {
  std::vector<Robot> list(20, Robot{.species = predator});
  list.insert(list.end(), 7, Robot{.species = prey});
  CHECK_FALSE(VictimFloor{}.may_die(prey, HandPopulation{list}.view()));
  CHECK(VictimFloor{{.floor = 6}}.may_die(prey, HandPopulation{list}.view()));
  list.push_back({.species = prey, .active = false});
  CHECK(VictimFloor{}.may_die(prey, HandPopulation{list}.view()));
}

TEST_CASE("victim floor: floor 0 -> the last one may die, extinct species -> none may die") {
  CHECK(VictimFloor{{.floor = 0}}.may_die(prey, HandPopulation{{{.species = prey}}}.view()));
  CHECK_FALSE(VictimFloor{{.floor = 0}}.may_die(prey, HandPopulation{{{.species = predator}}}.view()));
}

TEST_CASE("victim floor: food chain -> each species by its own count") {
  const HandPopulation robots{
      {{.species = plant}, {.species = plant}, {.species = plant}, {.species = grazer}, {.species = hunter}}, chain_web()};
  CHECK(VictimFloor{{.floor = 2}}.may_die(plant, robots.view()));
  CHECK_FALSE(VictimFloor{{.floor = 2}}.may_die(grazer, robots.view()));
}
