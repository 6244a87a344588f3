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

TEST_CASE("hungriest else oldest: equal hunger -> the earlier born") {
  const HandPopulation robots{{{.species = predator, .fed_tick = 10, .id = 9}, {.species = predator, .fed_tick = 10, .id = 4}}};
  CHECK(HungriestElseOldest{}.victims(robots.view(), [](BodyIndex) { return false; }) == Chosen{1});
}

TEST_CASE("hungriest else oldest: without predators -> none dies") {
  const auto none_spared = [](BodyIndex) { return false; };
  CHECK(HungriestElseOldest{}.victims(HandPopulation{{{.species = prey}}}.view(), none_spared).empty());
  CHECK(HungriestElseOldest{}.victims(HandPopulation{{}}.view(), none_spared).empty());
}

TEST_CASE("hungriest else oldest: food chain -> every species that eats can starve") {
  const HandPopulation robots{{{.species = plant, .fed_tick = 0, .id = 0},
                               {.species = grazer, .fed_tick = 3, .id = 8},
                               {.species = hunter, .fed_tick = 5, .id = 9},
                               {.species = grazer, .fed_tick = 7, .id = 2}},
                              chain_web()};
  CHECK(HungriestElseOldest{}.victims(robots.view(), [](BodyIndex) { return false; }) == Chosen{1});
  CHECK(HungriestElseOldest{}.victims(robots.view(), [](BodyIndex body) { return body == 1; }) == Chosen{3});
}

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

namespace {

const auto none_exempt = [](BodyIndex) { return false; };

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
  CHECK(HungriestShare{{.share = 0.5}}.victims(hungry.view(), [](BodyIndex) { return true; }).empty());
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
