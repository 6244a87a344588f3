// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/killer.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("killer: catch -> the hunter is the parent") {
  const reproduction::parent::Killer rule;
  const HandPopulation robots{
      {{.species = prey}, {.species = predator, .x_m = 0.1, .id = 41}, {.species = predator, .x_m = 0.9, .id = 42}}};
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = 0, .cause = Cause::caught, .killer = 2}, robots.view(), rng);
  REQUIRE(parent);
  CHECK(parent->id == 42);
  CHECK(parent->species == predator);
  CHECK(parent->genome == robots.individuals[2].genome);
}

TEST_CASE("killer: death without a killer -> no parent") {
  Rng rng{1, Stream::parent};
  const HandPopulation robots{{{.species = prey}, {.species = predator}}};
  CHECK_FALSE(reproduction::parent::Killer{}.parent({.body = 0, .cause = Cause::sacrificed, .killer = {}}, robots.view(), rng));
}
