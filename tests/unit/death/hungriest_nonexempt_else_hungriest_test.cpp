// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt_else_hungriest.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using death::starvation::choice::HungriestNonexemptElseHungriest;
using Chosen = std::vector<BodyIndex>;

namespace {

const auto all_spared = [](BodyIndex) { return true; };

}  // namespace

TEST_CASE("hungriest nonexempt else hungriest: some exempt -> skipped, all exempt -> the hungriest") {
  const HandPopulation robots{{{.species = prey, .fed_tick = 0},
                               {.species = predator, .fed_tick = 30},
                               {.species = predator, .fed_tick = 10},
                               {.species = predator, .fed_tick = 20}}};
  const HungriestNonexemptElseHungriest rule;
  CHECK(rule.victims(robots.view(), [](BodyIndex) { return false; }) == Chosen{2});
  CHECK(rule.victims(robots.view(), [](BodyIndex body) { return body == 2; }) == Chosen{3});
  CHECK(rule.victims(robots.view(), [](BodyIndex body) { return body != 1; }) == Chosen{1});
  CHECK(rule.victims(robots.view(), all_spared) == Chosen{2});
}

TEST_CASE("hungriest nonexempt else hungriest: equal hunger -> the earlier born") {
  const HandPopulation robots{{{.species = predator, .fed_tick = 10, .id = 9}, {.species = predator, .fed_tick = 10, .id = 4}}};
  CHECK(HungriestNonexemptElseHungriest{}.victims(robots.view(), all_spared) == Chosen{1});
}

TEST_CASE("hungriest nonexempt else hungriest: no predators -> none dies") {
  CHECK(HungriestNonexemptElseHungriest{}.victims(HandPopulation{{{.species = prey}}}.view(), all_spared).empty());
  CHECK(HungriestNonexemptElseHungriest{}.victims(HandPopulation{{}}.view(), all_spared).empty());
}
