// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/floor/active_victim_floor.hpp>
#include <trophic/death/floor/no_floor.hpp>
#include <trophic/death/floor/victim_floor.hpp>

using namespace trophic;
using namespace trophic::test;
using death::floor::ActiveVictimFloor;
using death::floor::VictimFloor;

TEST_CASE("active victim floor: number of active and inactive prey -> whether one may die") {
  struct Case {
    std::size_t active, inactive;
    bool may_die;
  };
  for (const auto& [active, inactive, may_die] :
       {Case{8, 0, true}, Case{7, 0, false}, Case{7, 5, false}, Case{8, 5, true}, Case{0, 9, false}, Case{0, 0, false}}) {
    CAPTURE(active);
    CAPTURE(inactive);
    std::vector<Robot> list(10, Robot{.species = predator});
    list.insert(list.end(), active, Robot{.species = prey});
    list.insert(list.end(), inactive, Robot{.species = prey, .active = false});
    CHECK(ActiveVictimFloor{}.may_die(prey, HandPopulation{list}.view()) == may_die);
  }
}

TEST_CASE("active victim floor: another floor, none, or a food chain -> each species by its own count") {
  const HandPopulation robots{{{.species = plant},
                               {.species = plant},
                               {.species = plant, .active = false},
                               {.species = grazer, .active = false},
                               {.species = hunter}},
                              chain_web()};
  CHECK(ActiveVictimFloor{{.floor = 1}}.may_die(plant, robots.view()));
  CHECK_FALSE(ActiveVictimFloor{{.floor = 2}}.may_die(plant, robots.view()));
  CHECK(ActiveVictimFloor{{.floor = 0}}.may_die(plant, robots.view()));
  CHECK_FALSE(ActiveVictimFloor{{.floor = 0}}.may_die(grazer, robots.view()));
}

TEST_CASE("no floor: last prey -> may die") {
  const HandPopulation robots{{{.species = prey}, {.species = predator}}};
  CHECK(death::floor::NoFloor{}.may_die(prey, robots.view()));
}

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
