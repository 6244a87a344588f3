// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/no_parent.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no parent: prey and a killer present -> none") {
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 0.5}}};
  Rng rng{1, Stream::parent};
  CHECK_FALSE(reproduction::parent::NoParent{}.parent({.body = 0, .cause = Cause::caught, .killer = 1}, robots.view(), rng));
}
