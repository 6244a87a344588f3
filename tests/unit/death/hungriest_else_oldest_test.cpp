// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <support/hand_population.hpp>
#include <trophic/death/starvation/choice/hungriest_else_oldest.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using death::starvation::choice::HungriestElseOldest;
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
