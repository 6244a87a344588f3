// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/interval/delayed_crowding_interval.hpp>
#include <trophic/death/starvation/interval/direct_crowding_interval.hpp>
#include <trophic/death/starvation/interval/never_due.hpp>

using namespace trophic;
using namespace trophic::test;
using death::starvation::StarvationClock;
using death::starvation::interval::DelayedCrowdingInterval;
using death::starvation::interval::DirectCrowdingInterval;

TEST_CASE("delayed crowding interval: p predators -> Delta = 25 - p ticks") {
  const DelayedCrowdingInterval rule;
  CHECK(rule.interval_ticks(with_predators(14).view()) == 11);
  CHECK(rule.interval_ticks(with_predators(7).view()) == 18);
  CHECK(rule.interval_ticks(with_predators(23).view()) == 2);
  CHECK(rule.interval_ticks(with_predators(0).view()) == 25);
  CHECK(DelayedCrowdingInterval{{.base_ticks = 40}}.interval_ticks(with_predators(14).view()) == 26);
}

TEST_CASE("delayed crowding interval: many predators -> never below 2 ticks") {
  CHECK(DelayedCrowdingInterval{}.interval_ticks(with_predators(24).view()) == 2);
  CHECK(DelayedCrowdingInterval{}.interval_ticks(with_predators(30).view()) == 2);
  CHECK(DelayedCrowdingInterval{}.interval_ticks(with_predators(40, 40).view()) == 2);
  CHECK(DelayedCrowdingInterval{{.min_interval_ticks = 5}}.interval_ticks(with_predators(23).view()) == 5);
}

TEST_CASE("delayed crowding interval: births since the last procedure -> due after the interval fixed then") {
  const DelayedCrowdingInterval rule;
  HandPopulation robots = with_predators(20);  // Delta would be 5 now
  const StarvationClock clock{.last_tick = 100, .interval_ticks = 11};
  CHECK_FALSE(rule.due(clock, robots.at_tick(105).view()));
  CHECK_FALSE(rule.due(clock, robots.at_tick(110).view()));
  CHECK(rule.due(clock, robots.at_tick(111).view()));
  CHECK(rule.due(clock, robots.at_tick(112).view()));
}

TEST_CASE("delayed crowding interval: only_above predators or fewer -> procedure waits, overdue") {
  const DelayedCrowdingInterval rule{{.only_above = 7}};
  const StarvationClock clock{.last_tick = 0, .interval_ticks = 2};
  CHECK_FALSE(rule.due(clock, with_predators(7).at_tick(500).view()));
  CHECK(rule.due(clock, with_predators(8).at_tick(500).view()));
}

TEST_CASE("delayed crowding interval: food chain -> p counts every hunting species") {
  const HandPopulation robots{{{.species = plant}, {.species = grazer}, {.species = grazer}, {.species = hunter}}, chain_web()};
  CHECK(DelayedCrowdingInterval{}.interval_ticks(robots.view()) == 22);
}

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

TEST_CASE("never due: any time since the last procedure -> not due") {
  HandPopulation robots{{{.species = predator}}};
  const death::starvation::StarvationClock clock{.last_tick = 0, .interval_ticks = 1};
  CHECK_FALSE(death::starvation::interval::NeverDue{}.due(clock, robots.at_tick(1'000'000).view()));
}
