// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <support/hand_population.hpp>
#include <trophic/death/activation/active_away_from_hunters.hpp>

using namespace trophic;
using namespace trophic::test;
using death::Activates;
using death::activation::ActiveAwayFromHunters;

TEST_CASE("active away from hunters: farther than 5 m from every predator -> active, at exactly 5 m -> not") {
  const ActiveAwayFromHunters rule;
  HandPopulation robots{
      {{.species = prey, .active = false}, {.species = predator, .x_m = 5.0}, {.species = predator, .x_m = -9.0}}};
  CHECK(rule.activates(0, robots.view()) == Activates::no);
  robots.poses[1].x_m = 5.0000001;
  CHECK(rule.activates(0, robots.view()) == Activates::yes);
  robots.poses[2].x_m = -3.0;
  CHECK(rule.activates(0, robots.view()) == Activates::no);
  CHECK(ActiveAwayFromHunters{{.distance_m = 2.0}}.activates(0, robots.view()) == Activates::yes);
}

TEST_CASE("active away from hunters: predator with the other tag -> counts, prey nearby -> ignored") {
  const ActiveAwayFromHunters rule;
  CHECK(
      rule.activates(
          0,
          HandPopulation{{{.species = prey, .tag = 1, .active = false}, {.species = predator, .x_m = 1.0, .tag = -1}}}.view()) ==
      Activates::no);
  CHECK(rule.activates(0, HandPopulation{{{.species = prey, .active = false}, {.species = prey, .x_m = 0.1}}}.view()) ==
        Activates::yes);
}

TEST_CASE("active away from hunters: food chain -> only species that eat the newborn count") {
  const ActiveAwayFromHunters rule;
  const HandPopulation robots{{{.species = plant, .active = false},
                               {.species = hunter, .x_m = 1.0},
                               {.species = grazer, .x_m = 6.0, .active = false},
                               {.species = grazer, .x_m = 6.5, .active = false}},
                              chain_web()};
  CHECK(rule.activates(0, robots.view()) == Activates::yes);
  CHECK(rule.activates(2, robots.view()) == Activates::no);  // 5 m from the hunter
  CHECK(rule.activates(3, robots.view()) == Activates::yes);
}

TEST_CASE("active away from hunters: any order of bodies -> same result") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 10, chain_web());
    const auto order = random_order(seed, 10);
    const HandPopulation moved = robots.reordered(order);
    for (BodyIndex body = 0; body < 10; ++body) {
      RC_ASSERT(ActiveAwayFromHunters{}.activates(body, moved.view()) ==
                ActiveAwayFromHunters{}.activates(order[body], robots.view()));
    }
  }));
}
