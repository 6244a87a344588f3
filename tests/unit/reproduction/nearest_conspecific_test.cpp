// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("nearest conspecific: the closest of the dying one's species, tags and activity ignored, alone: nobody") {
  const reproduction::parent::NearestConspecific rule;
  Rng rng{1, Stream::parent};
  const HandPopulation robots{{{.species = prey},
                               {.species = predator, .x_m = 0.5},
                               {.species = prey, .x_m = 8.0},
                               {.species = prey, .x_m = 7.0, .tag = -1, .active = false, .id = 70}}};
  const auto parent = rule.parent({.body = 0, .cause = Cause::senescence, .successor = prey}, robots.view(), rng);
  REQUIRE(parent);
  CHECK(parent->id == 70);
  CHECK(parent->species == prey);
  CHECK_FALSE(rule.parent({.body = 1, .cause = Cause::senescence, .successor = predator}, robots.view(), rng));
}
