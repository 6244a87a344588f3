// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <optional>
#include <support/hand_population.hpp>
#include <trophic/death/starvation/hungriest_unspared.hpp>

using namespace trophic;
using namespace trophic::test;
using death::starvation::HungriestUnspared;

namespace {

const auto nobody_spared = [](BodyIndex) { return false; };
const auto everyone_spared = [](BodyIndex) { return true; };

}  // namespace

TEST_CASE("hungriest unspared: the predator with most ticks since birth or last catch, prey never") {
  const HandPopulation robots{{{.species = prey, .fed_tick = 0},
                               {.species = predator, .fed_tick = 30},
                               {.species = predator, .fed_tick = 10},
                               {.species = predator, .fed_tick = 20}}};
  CHECK(HungriestUnspared{}.victim(robots.view(), nobody_spared) == 2);
  CHECK(HungriestUnspared{}.victim(robots.view(), [](BodyIndex body) { return body == 2; }) == 3);
  CHECK(HungriestUnspared{}.victim(robots.view(), [](BodyIndex body) { return body != 1; }) == 1);
}

TEST_CASE("hungriest unspared: at equal hunger the earlier born") {
  const HandPopulation robots{{{.species = predator, .fed_tick = 10, .id = 9}, {.species = predator, .fed_tick = 10, .id = 4}}};
  CHECK(HungriestUnspared{}.victim(robots.view(), nobody_spared) == 1);
}

TEST_CASE("hungriest unspared: nobody if all are spared") {
  const HandPopulation robots{{{.species = predator, .fed_tick = 30}, {.species = predator, .fed_tick = 10}}};
  CHECK(HungriestUnspared{}.victim(robots.view(), everyone_spared) == std::nullopt);
}

TEST_CASE("hungriest unspared: nobody without predators") {
  CHECK(HungriestUnspared{}.victim(HandPopulation{{{.species = prey}}}.view(), nobody_spared) == std::nullopt);
  CHECK(HungriestUnspared{}.victim(HandPopulation{{}}.view(), nobody_spared) == std::nullopt);
}

TEST_CASE("hungriest unspared: in a food chain every species that eats somebody can starve") {
  const HandPopulation robots{
      {{.species = plant, .fed_tick = 0}, {.species = grazer, .fed_tick = 3}, {.species = hunter, .fed_tick = 5}}, chain_web()};
  CHECK(HungriestUnspared{}.victim(robots.view(), nobody_spared) == 1);
  CHECK(HungriestUnspared{}.victim(robots.view(), [](BodyIndex body) { return body == 1; }) == 2);
}

TEST_CASE("hungriest unspared: nobody hungrier is left unspared, and the order of bodies does not matter") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 12, chain_web());
    const auto spared = [&](const HandPopulation& list) {
      return [&list](BodyIndex body) { return list.individuals[body].tag == 1; };
    };
    const auto order = random_order(seed, 12);
    const HandPopulation moved = robots.reordered(order);
    const auto victim = HungriestUnspared{}.victim(robots.view(), spared(robots));
    const auto victim_moved = HungriestUnspared{}.victim(moved.view(), spared(moved));
    RC_ASSERT(victim.has_value() == victim_moved.has_value());
    if (!victim) return;
    RC_ASSERT(order[*victim_moved] == *victim);
    for (BodyIndex body = 0; body < 12; ++body) {
      const Individual& other = robots.individuals[body];
      if (robots.web.hunts(other.species) && other.tag != 1) RC_ASSERT(other.fed_tick >= robots.individuals[*victim].fed_tick);
    }
  }));
}
