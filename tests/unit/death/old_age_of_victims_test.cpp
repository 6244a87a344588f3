// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/senescence/old_age_of_victims.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("old age of victims: hunted species at max_age -> dies, top predator -> never") {
  HandPopulation robots{{{.species = plant}, {.species = grazer, .age_from_s = 100.0}, {.species = hunter}}, chain_web()};
  Rng rng{1, Stream::senescence};
  const auto dies = [&](std::int64_t tick, BodyIndex body) {
    robots.at_tick(tick);
    return death::senescence::OldAgeOfVictims{}.dies(robots.individuals[body], robots.view(), rng);
  };
  CHECK_FALSE(dies(299, 0));
  CHECK(dies(300, 0));
  CHECK_FALSE(dies(349, 1));
  CHECK(dies(350, 1));
  CHECK_FALSE(dies(100'000, 2));
}
