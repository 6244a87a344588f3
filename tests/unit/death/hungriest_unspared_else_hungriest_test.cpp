// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <support/hand_population.hpp>
#include <trophic/death/starvation/hungriest_unspared_else_hungriest.hpp>

using namespace trophic;
using namespace trophic::test;
using death::starvation::HungriestUnsparedElseHungriest;

namespace {

const auto all_spared = [](BodyIndex) { return true; };

}  // namespace

TEST_CASE("hungriest unspared else hungriest: who is spared is passed over, unless everybody is") {
  const HandPopulation robots{{{.species = prey, .fed_tick = 0},
                               {.species = predator, .fed_tick = 30},
                               {.species = predator, .fed_tick = 10},
                               {.species = predator, .fed_tick = 20}}};
  const HungriestUnsparedElseHungriest rule;
  CHECK(rule.victim(robots.view(), [](BodyIndex) { return false; }) == 2);
  CHECK(rule.victim(robots.view(), [](BodyIndex body) { return body == 2; }) == 3);
  CHECK(rule.victim(robots.view(), [](BodyIndex body) { return body != 1; }) == 1);
  CHECK(rule.victim(robots.view(), all_spared) == 2);
}

TEST_CASE("hungriest unspared else hungriest: at equal hunger the earlier born") {
  const HandPopulation robots{{{.species = predator, .fed_tick = 10, .id = 9}, {.species = predator, .fed_tick = 10, .id = 4}}};
  CHECK(HungriestUnsparedElseHungriest{}.victim(robots.view(), all_spared) == 1);
}

TEST_CASE("hungriest unspared else hungriest: nobody without predators") {
  CHECK(HungriestUnsparedElseHungriest{}.victim(HandPopulation{{{.species = prey}}}.view(), all_spared) == std::nullopt);
  CHECK(HungriestUnsparedElseHungriest{}.victim(HandPopulation{{}}.view(), all_spared) == std::nullopt);
}
