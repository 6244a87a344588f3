// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/reprieve/near_perceived_victim.hpp>

using namespace trophic;
using namespace trophic::test;
using death::reprieve::NearPerceivedVictim;

TEST_CASE("near perceived victim: spared at exactly 5 m from a prey that it perceives, not beyond") {
  const NearPerceivedVictim rule;
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 5.0}}};
  CHECK(rule.spared(0, robots.view()));
  robots.poses[1].x_m = 5.0000001;
  CHECK_FALSE(rule.spared(0, robots.view()));
  CHECK(NearPerceivedVictim{{.range_m = 6.0}}.spared(0, robots.view()));
}

TEST_CASE("near perceived victim: the prey that switches its tag ends the reprieve, whatever the predator remembers") {
  const NearPerceivedVictim rule;
  HandPopulation robots{{{.species = predator, .memory = {.adversary_distance_m = 2.0}}, {.species = prey, .x_m = 2.0}}};
  CHECK(rule.spared(0, robots.view()));
  robots.individuals[1].tag = -1;
  CHECK_FALSE(rule.spared(0, robots.view()));
}

TEST_CASE("near perceived victim: a hidden prey at hand does not spare, a visible one farther off does") {
  const NearPerceivedVictim rule;
  CHECK(rule.spared(0, HandPopulation{{{.species = predator},
                                       {.species = prey, .x_m = 0.5, .tag = -1},
                                       {.species = prey, .x_m = 0.7, .active = false},
                                       {.species = prey, .x_m = 4.0}}}
                           .view()));
  CHECK_FALSE(rule.spared(0, HandPopulation{{{.species = predator}, {.species = predator, .x_m = 1.0}}}.view()));
  CHECK_FALSE(rule.spared(0, HandPopulation{{{.species = predator}}}.view()));
}

TEST_CASE("near perceived victim: what eats the hunter does not spare it") {
  const HandPopulation robots{{{.species = grazer}, {.species = hunter, .x_m = 1.0}, {.species = plant, .x_m = 4.0}},
                              chain_web()};
  CHECK(NearPerceivedVictim{}.spared(0, robots.view()));
  CHECK_FALSE(NearPerceivedVictim{{.range_m = 2.0}}.spared(0, robots.view()));
}
