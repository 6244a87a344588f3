// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <support/hand_population.hpp>
#include <trophic/death/starvation_schedule/crowding_interval.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using death::StarvationClock;
using death::starvation_schedule::CrowdingInterval;

namespace {

HandPopulation with_predators(std::size_t predators, std::size_t robots = 30) {
  std::vector<Robot> list(robots);
  for (std::size_t i = 0; i < predators; ++i) list[i].species = predator;
  return HandPopulation{list};
}

}  // namespace

TEST_CASE("crowding interval: Delta = 25 - p ticks") {
  const CrowdingInterval rule;
  CHECK(rule.interval_ticks(with_predators(14).view()) == 11);
  CHECK(rule.interval_ticks(with_predators(7).view()) == 18);
  CHECK(rule.interval_ticks(with_predators(23).view()) == 2);
  CHECK(rule.interval_ticks(with_predators(0).view()) == 25);
  CHECK(CrowdingInterval{{.base_ticks = 40}}.interval_ticks(with_predators(14).view()) == 26);
}

TEST_CASE("crowding interval: never below 2 ticks") {
  CHECK(CrowdingInterval{}.interval_ticks(with_predators(24).view()) == 2);
  CHECK(CrowdingInterval{}.interval_ticks(with_predators(30).view()) == 2);
  CHECK(CrowdingInterval{}.interval_ticks(with_predators(40, 40).view()) == 2);
  CHECK(CrowdingInterval{{.min_interval_ticks = 5}}.interval_ticks(with_predators(23).view()) == 5);
}

TEST_CASE("crowding interval: due once the interval fixed at the last procedure has passed, whoever was born since") {
  const CrowdingInterval rule;
  HandPopulation robots = with_predators(20);  // Delta would be 5 now
  const StarvationClock clock{.last_tick = 100, .interval_ticks = 11};
  CHECK_FALSE(rule.due(clock, robots.at_tick(105).view()));
  CHECK_FALSE(rule.due(clock, robots.at_tick(110).view()));
  CHECK(rule.due(clock, robots.at_tick(111).view()));
  CHECK(rule.due(clock, robots.at_tick(112).view()));
}

TEST_CASE("crowding interval: reevaluated, the number of predators of this tick decides") {
  const CrowdingInterval rule{{.reevaluated = true}};
  HandPopulation robots = with_predators(20);
  const StarvationClock clock{.last_tick = 100, .interval_ticks = 11};
  CHECK_FALSE(rule.due(clock, robots.at_tick(104).view()));
  CHECK(rule.due(clock, robots.at_tick(105).view()));
  HandPopulation fewer = with_predators(8);
  CHECK_FALSE(rule.due(clock, fewer.at_tick(116).view()));
  CHECK(rule.due(clock, fewer.at_tick(117).view()));
}

TEST_CASE("crowding interval: with only_above predators or fewer the procedure waits, overdue") {
  const CrowdingInterval rule{{.only_above = 7}};
  const StarvationClock clock{.last_tick = 0, .interval_ticks = 2};
  CHECK_FALSE(rule.due(clock, with_predators(7).at_tick(500).view()));
  CHECK(rule.due(clock, with_predators(8).at_tick(500).view()));
}

TEST_CASE("crowding interval: in a food chain p counts every species that eats somebody") {
  const HandPopulation robots{{{.species = plant}, {.species = grazer}, {.species = grazer}, {.species = hunter}}, chain_web()};
  CHECK(CrowdingInterval{}.interval_ticks(robots.view()) == 22);
}
