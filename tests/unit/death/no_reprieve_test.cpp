// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/reprieve/no_reprieve.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no reprieve: not even beside a prey") {
  const HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 0.5}}};
  CHECK_FALSE(death::reprieve::NoReprieve{}.spared(0, robots.view(), robots.perceives()));
}
