// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/no_starvation.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("nobody starves: not the hungriest predator") {
  const HandPopulation robots{{{.species = predator, .fed_tick = -500}}};
  CHECK(death::starvation::NoStarvation{}.starving(robots.view(), robots.perceives()) == death::Starving{});
}
