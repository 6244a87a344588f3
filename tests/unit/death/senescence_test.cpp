// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/senescence/no_senescence.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/death/senescence/old_age_of_victims.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no senescence: any age -> no death") {
  HandPopulation robots{{{.species = predator}, {.species = prey}}};
  Rng rng{1, Stream::senescence};
  robots.at_tick(1'000'000);
  CHECK_FALSE(death::senescence::NoSenescence{}.dies(robots.individuals[0], robots.view(), rng));
  CHECK_FALSE(death::senescence::NoSenescence{}.dies(robots.individuals[1], robots.view(), rng));
}

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

TEST_CASE("old age: age of exactly max_age or more -> dies") {
  HandPopulation robots{{{.species = prey, .age_from_s = 100.0}}};
  Rng rng{1, Stream::senescence};
  const auto dies = [&](std::int64_t tick, const death::senescence::OldAge& rule) {
    robots.at_tick(tick);
    return rule.dies(robots.individuals[0], robots.view(), rng);
  };
  CHECK_FALSE(dies(349, {}));
  CHECK(dies(350, {}));
  CHECK(dies(351, {}));
  CHECK_FALSE(dies(54, {{.max_age_s = 10.0}}));
  CHECK(dies(55, {{.max_age_s = 10.0}}));
}
