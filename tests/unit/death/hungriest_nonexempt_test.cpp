// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <support/hand_population.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using death::starvation::choice::HungriestNonexempt;
using Chosen = std::vector<BodyIndex>;

namespace {

const auto no_exemption = [](BodyIndex) { return false; };
const auto all_exempt = [](BodyIndex) { return true; };

}  // namespace

TEST_CASE("hungriest nonexempt: different hunger -> predator with most ticks since birth or catch, never prey") {
  const HandPopulation robots{{{.species = prey, .fed_tick = 0},
                               {.species = predator, .fed_tick = 30},
                               {.species = predator, .fed_tick = 10},
                               {.species = predator, .fed_tick = 20}}};
  CHECK(HungriestNonexempt{}.victims(robots.view(), no_exemption) == Chosen{2});
  CHECK(HungriestNonexempt{}.victims(robots.view(), [](BodyIndex body) { return body == 2; }) == Chosen{3});
  CHECK(HungriestNonexempt{}.victims(robots.view(), [](BodyIndex body) { return body != 1; }) == Chosen{1});
}

TEST_CASE("hungriest nonexempt: equal hunger -> the earlier born") {
  const HandPopulation robots{{{.species = predator, .fed_tick = 10, .id = 9}, {.species = predator, .fed_tick = 10, .id = 4}}};
  CHECK(HungriestNonexempt{}.victims(robots.view(), no_exemption) == Chosen{1});
}

TEST_CASE("hungriest nonexempt: all exempt -> none dies") {
  const HandPopulation robots{{{.species = predator, .fed_tick = 30}, {.species = predator, .fed_tick = 10}}};
  CHECK(HungriestNonexempt{}.victims(robots.view(), all_exempt).empty());
}

TEST_CASE("hungriest nonexempt: no predators -> none dies") {
  CHECK(HungriestNonexempt{}.victims(HandPopulation{{{.species = prey}}}.view(), no_exemption).empty());
  CHECK(HungriestNonexempt{}.victims(HandPopulation{{}}.view(), no_exemption).empty());
}

TEST_CASE("hungriest nonexempt: food chain -> every hunting species can starve") {
  const HandPopulation robots{
      {{.species = plant, .fed_tick = 0}, {.species = grazer, .fed_tick = 3}, {.species = hunter, .fed_tick = 5}}, chain_web()};
  CHECK(HungriestNonexempt{}.victims(robots.view(), no_exemption) == Chosen{1});
  CHECK(HungriestNonexempt{}.victims(robots.view(), [](BodyIndex body) { return body == 1; }) == Chosen{2});
}

TEST_CASE("hungriest nonexempt: random populations -> no hungrier one left, any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 12, chain_web());
    const auto exempt = [&](const HandPopulation& list) {
      return [&list](BodyIndex body) { return list.individuals[body].tag == 1; };
    };
    const auto order = random_order(seed, 12);
    const HandPopulation moved = robots.reordered(order);
    const auto victims = HungriestNonexempt{}.victims(robots.view(), exempt(robots));
    const auto victims_moved = HungriestNonexempt{}.victims(moved.view(), exempt(moved));
    RC_ASSERT(victims.size() == victims_moved.size());
    RC_ASSERT(victims.size() <= 1U);
    if (victims.empty()) return;
    RC_ASSERT(order[victims_moved[0]] == victims[0]);
    for (BodyIndex body = 0; body < 12; ++body) {
      const Individual& other = robots.individuals[body];
      if (robots.web.hunts(other.species) && other.tag != 1) RC_ASSERT(other.fed_tick >= robots.individuals[victims[0]].fed_tick);
    }
  }));
}
