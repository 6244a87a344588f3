// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <set>
#include <support/hand_population.hpp>
#include <trophic/death/starvation/choice/hungriest_else_oldest.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt_else_hungriest.hpp>
#include <trophic/death/starvation/choice/hungriest_share.hpp>

using namespace trophic;
using namespace trophic::test;
using death::starvation::choice::HungriestElseOldest;
using death::starvation::choice::HungriestNonexempt;
using death::starvation::choice::HungriestNonexemptElseHungriest;
using death::starvation::choice::HungriestShare;

using Chosen = std::vector<BodyIndex>;

namespace {

const auto none_exempt = [](BodyIndex) { return false; };
const auto all_exempt = [](BodyIndex) { return true; };

const HandPopulation equally_hungry{
    {{.species = predator, .fed_tick = 10, .id = 9}, {.species = predator, .fed_tick = 10, .id = 4}}};
const std::vector<HandPopulation> without_predators{HandPopulation{{{.species = prey}}}, HandPopulation{{}}};

/// The predators 2, 3 and 1, the hungriest first; body 0 is a hungrier prey.
const HandPopulation three{{{.species = prey, .fed_tick = 0},
                            {.species = predator, .fed_tick = 30},
                            {.species = predator, .fed_tick = 10},
                            {.species = predator, .fed_tick = 20}}};

}  // namespace

TEST_CASE_TEMPLATE("choice of who starves: equal hunger -> the earlier born, no predators -> none", Choice, HungriestElseOldest,
                   HungriestNonexempt, HungriestNonexemptElseHungriest) {
  CHECK(Choice{}.victims(equally_hungry.view(), none_exempt) == Chosen{1});
  for (const HandPopulation& robots : without_predators) CHECK(Choice{}.victims(robots.view(), none_exempt).empty());
}

TEST_CASE_TEMPLATE("hungriest nonexempt: some exempt -> predator with most ticks since birth or catch, never prey", Choice,
                   HungriestNonexempt, HungriestNonexemptElseHungriest) {
  CHECK(Choice{}.victims(three.view(), none_exempt) == Chosen{2});
  CHECK(Choice{}.victims(three.view(), [](BodyIndex body) { return body == 2; }) == Chosen{3});
  CHECK(Choice{}.victims(three.view(), [](BodyIndex body) { return body != 1; }) == Chosen{1});
}

TEST_CASE("hungriest else oldest: exempt predators -> the one that dies") {
  // hungriest: body 2; in order of birth: bodies 3, 1, 2; the prey, older and hungrier than all, never
  const HandPopulation robots{{{.species = prey, .fed_tick = 0, .id = 1},
                               {.species = predator, .fed_tick = 20, .id = 6},
                               {.species = predator, .fed_tick = 10, .id = 9},
                               {.species = predator, .fed_tick = 30, .id = 5}}};
  struct Case {
    std::set<BodyIndex> exempt;
    Chosen dies;
  };
  for (const auto& [exempt, dies] : {Case{{}, {2}}, Case{{1, 3}, {2}}, Case{{2}, {3}}, Case{{2, 3}, {1}}, Case{{1, 2, 3}, {}}}) {
    CAPTURE(exempt.size());
    CHECK(HungriestElseOldest{}.victims(robots.view(), [&](BodyIndex body) { return exempt.contains(body); }) == dies);
  }
}

TEST_CASE("hungriest else oldest: food chain -> every species that eats can starve") {
  const HandPopulation robots{{{.species = plant, .fed_tick = 0, .id = 0},
                               {.species = grazer, .fed_tick = 3, .id = 8},
                               {.species = hunter, .fed_tick = 5, .id = 9},
                               {.species = grazer, .fed_tick = 7, .id = 2}},
                              chain_web()};
  CHECK(HungriestElseOldest{}.victims(robots.view(), none_exempt) == Chosen{1});
  CHECK(HungriestElseOldest{}.victims(robots.view(), [](BodyIndex body) { return body == 1; }) == Chosen{3});
}

TEST_CASE("hungriest nonexempt else hungriest: all exempt -> the hungriest") {
  const HungriestNonexemptElseHungriest rule;
  CHECK(rule.victims(three.view(), all_exempt) == Chosen{2});
  CHECK(rule.victims(equally_hungry.view(), all_exempt) == Chosen{1});
  for (const HandPopulation& robots : without_predators) CHECK(rule.victims(robots.view(), all_exempt).empty());
}

TEST_CASE("hungriest nonexempt: all exempt -> none dies") {
  CHECK(HungriestNonexempt{}.victims(three.view(), all_exempt).empty());
}

TEST_CASE("hungriest nonexempt: food chain -> every hunting species can starve") {
  const HandPopulation robots{
      {{.species = plant, .fed_tick = 0}, {.species = grazer, .fed_tick = 3}, {.species = hunter, .fed_tick = 5}}, chain_web()};
  CHECK(HungriestNonexempt{}.victims(robots.view(), none_exempt) == Chosen{1});
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

namespace {

/// Chosen 1 to 4 are predators, the hungriest first; body 0 is a hungrier prey.
const HandPopulation hungry{{{.species = prey, .fed_tick = 0},
                             {.species = predator, .fed_tick = 10},
                             {.species = predator, .fed_tick = 20},
                             {.species = predator, .fed_tick = 30},
                             {.species = predator, .fed_tick = 40}}};

}  // namespace

TEST_CASE("hungriest share: share of the predators -> rounded up, the hungriest first") {
  CHECK(HungriestShare{{.share = 0.0}}.victims(hungry.view(), none_exempt).empty());
  CHECK(HungriestShare{{.share = 0.01}}.victims(hungry.view(), none_exempt) == Chosen{1});
  CHECK(HungriestShare{{.share = 0.5}}.victims(hungry.view(), none_exempt) == Chosen{1, 2});
  CHECK(HungriestShare{{.share = 0.51}}.victims(hungry.view(), none_exempt) == Chosen{1, 2, 3});
  CHECK(HungriestShare{{.share = 1.0}}.victims(hungry.view(), none_exempt) == Chosen{1, 2, 3, 4});
}

TEST_CASE("hungriest share: exempt predators -> skipped") {
  const auto exempt = [](BodyIndex body) { return body == 1 || body == 3; };
  CHECK(HungriestShare{{.share = 0.5}}.victims(hungry.view(), exempt) == Chosen{2, 4});
  CHECK(HungriestShare{{.share = 0.5}}.victims(hungry.view(), all_exempt).empty());
}

TEST_CASE("hungriest share: default, up to 14 predators -> one, as hungriest nonexempt") {
  for (const std::size_t predators : {0U, 1U, 13U, 14U}) {
    CAPTURE(predators);
    const HandPopulation robots = with_predators(predators);
    CHECK(HungriestShare{}.victims(robots.view(), none_exempt) ==
          death::starvation::choice::HungriestNonexempt{}.victims(robots.view(), none_exempt));
  }
  CHECK(HungriestShare{}.victims(with_predators(15).view(), none_exempt).size() == 2);
}
