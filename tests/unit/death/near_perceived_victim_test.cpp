// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/exemption/near_perceived_victim.hpp>

using namespace trophic;
using namespace trophic::test;
using death::starvation::exemption::NearPerceivedVictim;

namespace {

bool exempt(const NearPerceivedVictim& rule, const HandPopulation& robots) {
  return rule.is_exempt(0, robots.view(), robots.perceives());
}

}  // namespace

TEST_CASE("near perceived victim: exempt at exactly 5 m from a prey that it perceives, not beyond") {
  const NearPerceivedVictim rule;
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 5.0}}};
  CHECK(exempt(rule, robots));
  robots.poses[1].x_m = 5.0000001;
  CHECK_FALSE(exempt(rule, robots));
  CHECK(exempt(NearPerceivedVictim{{.range_m = 6.0}}, robots));
}

TEST_CASE("near perceived victim: the prey that switches its tag ends the exemption") {
  const NearPerceivedVictim rule;
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 2.0}}};
  CHECK(exempt(rule, robots));
  robots.individuals[1].tag = -1;
  CHECK_FALSE(exempt(rule, robots));
}

TEST_CASE("near perceived victim: a hidden prey at hand does not spare, a visible one farther off does") {
  const NearPerceivedVictim rule;
  CHECK(exempt(rule, HandPopulation{{{.species = predator},
                                     {.species = prey, .x_m = 0.5, .tag = -1},
                                     {.species = prey, .x_m = 0.7, .active = false},
                                     {.species = prey, .x_m = 4.0}}}));
  CHECK_FALSE(exempt(rule, HandPopulation{{{.species = predator}, {.species = predator, .x_m = 1.0}}}));
  CHECK_FALSE(exempt(rule, HandPopulation{{{.species = predator}}}));
}

TEST_CASE("near perceived victim: what eats the hunter does not spare it") {
  const HandPopulation robots{{{.species = grazer}, {.species = hunter, .x_m = 1.0}, {.species = plant, .x_m = 4.0}},
                              chain_web()};
  CHECK(exempt(NearPerceivedVictim{}, robots));
  CHECK_FALSE(exempt(NearPerceivedVictim{{.range_m = 2.0}}, robots));
}
