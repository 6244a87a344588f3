// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt_else_hungriest.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using death::starvation::choice::HungriestNonexemptElseHungriest;
using Bodies = std::vector<BodyIndex>;

namespace {

const auto all_spared = [](BodyIndex) { return true; };

}  // namespace

TEST_CASE("hungriest unspared else hungriest: who is exempt is passed over, unless everybody is") {
  const HandPopulation robots{{{.species = prey, .fed_tick = 0},
                               {.species = predator, .fed_tick = 30},
                               {.species = predator, .fed_tick = 10},
                               {.species = predator, .fed_tick = 20}}};
  const HungriestNonexemptElseHungriest rule;
  CHECK(rule.victims(robots.view(), [](BodyIndex) { return false; }) == Bodies{2});
  CHECK(rule.victims(robots.view(), [](BodyIndex body) { return body == 2; }) == Bodies{3});
  CHECK(rule.victims(robots.view(), [](BodyIndex body) { return body != 1; }) == Bodies{1});
  CHECK(rule.victims(robots.view(), all_spared) == Bodies{2});
}

TEST_CASE("hungriest unspared else hungriest: at equal hunger the earlier born") {
  const HandPopulation robots{{{.species = predator, .fed_tick = 10, .id = 9}, {.species = predator, .fed_tick = 10, .id = 4}}};
  CHECK(HungriestNonexemptElseHungriest{}.victims(robots.view(), all_spared) == Bodies{1});
}

TEST_CASE("hungriest unspared else hungriest: nobody without predators") {
  CHECK(HungriestNonexemptElseHungriest{}.victims(HandPopulation{{{.species = prey}}}.view(), all_spared).empty());
  CHECK(HungriestNonexemptElseHungriest{}.victims(HandPopulation{{}}.view(), all_spared).empty());
}
