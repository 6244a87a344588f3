// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <memory>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/last_killer.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("last killer: whoever last caught somebody in this body, dead by now or not") {
  const reproduction::parent::LastKiller rule;
  const auto genome = std::make_shared<Genome>(Genome{.id = 5, .weights = {0.5}});
  const HandPopulation robots{
      {{.species = prey, .memory = {.last_killer = Ancestor{.id = 77, .species = predator, .genome = genome}}},
       {.species = prey},
       {.species = predator, .x_m = 0.1}}};
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = 0, .cause = Cause::sacrificed, .killer = {}}, robots.view(), rng);
  REQUIRE(parent);
  CHECK(parent->id == 77);
  CHECK(parent->genome == genome);
  CHECK_FALSE(rule.parent({.body = 1, .cause = Cause::sacrificed, .killer = {}}, robots.view(), rng));
  CHECK(rule.parent({.body = 0, .cause = Cause::sacrificed, .heir = predator}, robots.view(), rng));
  CHECK_FALSE(rule.parent({.body = 0, .cause = Cause::sacrificed, .heir = prey}, robots.view(), rng));
}
