// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/activation/always_active.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("always active: predator at the same place -> active, age counts from birth") {
  const HandPopulation robots{{{.species = prey, .active = false}, {.species = predator}}};
  CHECK(death::activation::AlwaysActive{}.activates(0, robots.view()) == death::Activates::yes);
}
