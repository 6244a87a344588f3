// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <memory>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/last_seen_victim.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("last seen victim: whoever the body remembers, at any distance, though another prey stands beside it") {
  const reproduction::parent::LastSeenVictim rule;
  const auto genome = std::make_shared<Genome>(Genome{.id = 5, .weights = {0.5}});
  const HandPopulation robots{
      {{.species = predator, .memory = {.last_seen_victim = Ancestor{.id = 77, .species = prey, .genome = genome}}},
       {.species = predator},
       {.species = prey, .x_m = 0.1}}};
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = 0, .cause = Cause::starved, .killer = {}}, robots.view(), rng);
  REQUIRE(parent);
  CHECK(parent->id == 77);
  CHECK(parent->species == prey);
  CHECK(parent->genome == genome);
  CHECK_FALSE(rule.parent({.body = 1, .cause = Cause::starved, .killer = {}}, robots.view(), rng));
}
