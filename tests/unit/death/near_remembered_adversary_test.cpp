// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/reprieve/near_remembered_adversary.hpp>

using namespace trophic;
using namespace trophic::test;
using death::reprieve::NearRememberedAdversary;

TEST_CASE("near remembered adversary: the stored distance decides, not where anybody stands now") {
  const NearRememberedAdversary rule;
  HandPopulation robots{{{.species = predator, .memory = {.adversary_distance_m = 4.9}},
                         {.species = predator, .memory = {.adversary_distance_m = 5.0}},
                         {.species = prey, .x_m = 0.1}}};
  CHECK(rule.spared(0, robots.view()));
  CHECK_FALSE(rule.spared(1, robots.view()));
  robots.poses[2].x_m = 50.0;
  CHECK(rule.spared(0, robots.view()));
  CHECK(NearRememberedAdversary{{.range_m = 6.0}}.spared(1, robots.view()));
}

TEST_CASE("near remembered adversary: a body that never perceived anybody is exempt") {
  CHECK(NearRememberedAdversary{}.spared(0, HandPopulation{{{.species = predator}}}.view()));
}
