// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/interval/never_due.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("never due: any time since the last procedure -> not due") {
  HandPopulation robots{{{.species = predator}}};
  const death::starvation::StarvationClock clock{.last_tick = 0, .interval_ticks = 1};
  CHECK_FALSE(death::starvation::interval::NeverDue{}.due(clock, robots.at_tick(1'000'000).view()));
}
