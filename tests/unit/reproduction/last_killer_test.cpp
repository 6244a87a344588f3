// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/last_killer.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using reproduction::parent::LastKiller;

TEST_CASE("last killer: whoever last caught somebody in this body, dead by now or not") {
  const LastKiller rule;
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 0.1}}};
  const std::vector<LastKiller::State> states{{.killer = ancestor(77, predator)}, {}};
  const std::vector<LastKiller::State> empty(2);
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = 0, .cause = Cause::sacrificed, .killer = {}}, robots.view(), rng, states);
  REQUIRE(parent);
  CHECK(parent->id == 77);
  CHECK(parent->genome == states[0].killer->genome);
  CHECK_FALSE(rule.parent({.body = 0, .cause = Cause::sacrificed, .killer = {}}, robots.view(), rng, empty));
  CHECK(rule.parent({.body = 0, .cause = Cause::sacrificed, .successor = predator}, robots.view(), rng, states));
  CHECK_FALSE(rule.parent({.body = 0, .cause = Cause::sacrificed, .successor = prey}, robots.view(), rng, states));
}

TEST_CASE("last killer: a catch is remembered in the caught body, whoever is born there") {
  const LastKiller rule;
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 0.1}}};
  LastKiller::State own{.killer = ancestor(77, predator)};
  rule.on_caught(own, 0, 1, robots.view());
  REQUIRE(own.killer);
  CHECK(own.killer->id == 1);
  CHECK(own.killer->genome == robots.individuals[1].genome);
  CHECK(rule.born({}, nullptr, own).killer == own.killer);
}
