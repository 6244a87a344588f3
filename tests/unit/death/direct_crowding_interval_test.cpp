// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/interval/direct_crowding_interval.hpp>

using namespace trophic;
using namespace trophic::test;
using death::starvation::StarvationClock;
using death::starvation::interval::DirectCrowdingInterval;

TEST_CASE("direct crowding interval: births since the last procedure -> number of predators of this tick decides") {
  const DirectCrowdingInterval rule;
  HandPopulation robots = with_predators(20);
  const StarvationClock clock{.last_tick = 100, .interval_ticks = 11};
  CHECK_FALSE(rule.due(clock, robots.at_tick(104).view()));
  CHECK(rule.due(clock, robots.at_tick(105).view()));
  HandPopulation fewer = with_predators(8);
  CHECK_FALSE(rule.due(clock, fewer.at_tick(116).view()));
  CHECK(rule.due(clock, fewer.at_tick(117).view()));
}

TEST_CASE("direct crowding interval: p predators -> Delta = 25 - p ticks, never below 2, or as set") {
  CHECK(DirectCrowdingInterval{}.interval_ticks(with_predators(14).view()) == 11);
  CHECK(DirectCrowdingInterval{}.interval_ticks(with_predators(30).view()) == 2);
  CHECK(DirectCrowdingInterval{{.base_ticks = 40, .min_interval_ticks = 20}}.interval_ticks(with_predators(14).view()) == 26);
  CHECK(DirectCrowdingInterval{{.base_ticks = 40, .min_interval_ticks = 20}}.interval_ticks(with_predators(23).view()) == 20);
}

TEST_CASE("direct crowding interval: only_above predators or fewer -> procedure waits, overdue") {
  const DirectCrowdingInterval rule{{.only_above = 7}};
  const StarvationClock clock{.last_tick = 0, .interval_ticks = 2};
  CHECK_FALSE(rule.due(clock, with_predators(7).at_tick(500).view()));
  CHECK(rule.due(clock, with_predators(8).at_tick(500).view()));
}
