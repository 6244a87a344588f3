// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/activation/ages_once_away_from_hunters.hpp>

using namespace trophic;
using namespace trophic::test;
using death::Activates;
using death::activation::AgesOnceAwayFromHunters;

TEST_CASE("ages once away from hunters: farther than 5 m from every predator -> active, age restarts") {
  const AgesOnceAwayFromHunters rule;
  HandPopulation robots{
      {{.species = prey, .active = false}, {.species = predator, .x_m = 5.0, .tag = -1}, {.species = prey, .x_m = 0.1}}};
  CHECK(rule.activates(0, robots.view()) == Activates::no);
  robots.poses[1].x_m = 5.0000001;
  CHECK(rule.activates(0, robots.view()) == Activates::yes_and_restarts_age);
  CHECK(AgesOnceAwayFromHunters{{.distance_m = 6.0}}.activates(0, robots.view()) == Activates::no);
}
