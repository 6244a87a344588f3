// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <support/hand_population.hpp>
#include <trophic/death/floor/active_victim_floor.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using death::floor::ActiveVictimFloor;

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
