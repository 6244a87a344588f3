// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <support/statistics.hpp>
#include <trophic/death/minimum_predators/sacrifice_random_victim.hpp>

using namespace trophic;
using namespace trophic::test;
using death::Sacrifice;
using death::minimum_predators::SacrificeRandomVictim;

namespace {

HandPopulation with(std::size_t predators, std::size_t preys) {
  std::vector<Robot> list(predators, Robot{.species = predator});
  list.insert(list.end(), preys, Robot{.species = prey});
  return HandPopulation{list};
}

std::vector<Sacrifice> sacrifices(const HandPopulation& robots, const SacrificeRandomVictim& rule = {}, std::uint64_t seed = 1) {
  Rng rng{seed, Stream::sacrifice};
  return rule.sacrifices(robots.view(), rng);
}

}  // namespace

TEST_CASE("sacrifice random victim: fewer than 7 predators -> one prey, 7 -> none") {
  CHECK(sacrifices(with(7, 23)).empty());
  const auto one = sacrifices(with(6, 24));
  REQUIRE(one.size() == 1);
  CHECK(one[0].successor == predator);
  CHECK(one[0].victim >= 6);
  CHECK(sacrifices(with(0, 30)).size() == 1);
  CHECK(sacrifices(with(7, 23), {{.below = 8}}).size() == 1);
  CHECK(sacrifices(with(8, 22), {{.below = 8}}).empty());
}

TEST_CASE("sacrifice random victim: no prey -> no sacrifice") {
  CHECK(sacrifices(with(3, 0)).empty());
}

TEST_CASE("sacrifice random victim: many draws -> uniform over all prey, inactive newborn included") {
  HandPopulation robots = with(2, 10);
  robots.individuals[5].active = false;
  std::vector<std::size_t> chosen(10, 0);
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) ++chosen.at(sacrifices(robots, {}, seed).at(0).victim - 2);
  CHECK(chi_square(chosen) < 33.7);  // 9 degrees of freedom: p = 1e-4
}

TEST_CASE("sacrifice random victim: food chain -> one for each species below its minimum") {
  const HandPopulation robots{{{.species = plant}, {.species = grazer}, {.species = hunter}, {.species = hunter}}, chain_web()};
  CHECK(sacrifices(robots) == std::vector<Sacrifice>{{.victim = 0, .successor = grazer}, {.victim = 1, .successor = hunter}});
  CHECK(sacrifices(robots, {{.below = 2}}) == std::vector<Sacrifice>{{.victim = 0, .successor = grazer}});
  CHECK(sacrifices(robots, {{.below = 1}}).empty());
}

TEST_CASE("sacrifice random victim: two species below their minimum eat the same prey -> two different victims") {
  const FoodWeb rivals{{"hare", "wolf", "lynx"}, {{.hunter = 1, .victim = 0}, {.hunter = 2, .victim = 0}}};
  const HandPopulation robots{{{.species = 0}, {.species = 0}, {.species = 1}, {.species = 2}}, rivals};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto both = sacrifices(robots, {}, seed);
    REQUIRE(both.size() == 2);
    CHECK(both[0].victim != both[1].victim);
  }
  const HandPopulation last{{{.species = 0}, {.species = 1}, {.species = 2}}, rivals};
  CHECK(sacrifices(last) == std::vector<Sacrifice>{{.victim = 0, .successor = 1}});
}

TEST_CASE("sacrifice random victim: one sacrifice -> one draw, none -> none") {
  Rng rng{1, Stream::sacrifice};
  Rng reference = rng;
  CHECK(SacrificeRandomVictim{}.sacrifices(with(7, 23).view(), rng).empty());
  CHECK(SacrificeRandomVictim{}.sacrifices(with(6, 24).view(), rng).at(0).victim == 6 + reference.index(24));
  CHECK(rng.bits() == reference.bits());
}
