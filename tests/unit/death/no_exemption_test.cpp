// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no exemption: predator next to a prey -> not exempt") {
  const HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 0.5}}};
  CHECK_FALSE(death::starvation::exemption::NoExemption{}.is_exempt(0, robots.view(), robots.perceives()));
}
