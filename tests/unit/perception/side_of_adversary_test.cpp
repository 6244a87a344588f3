// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <numbers>
#include <support/hand_population.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/perception/sensors/side_of_adversary.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("side of adversary: -1 on the left and +1 on the right, for prey and for predators") {
  const perception::sensors::SideOfAdversary rule;
  // both face +y: what has a smaller x is on the left
  const HandPopulation robots{{{.species = prey, .x_m = 1.0, .heading_rad = std::numbers::pi / 2.0},
                               {.species = predator, .x_m = -1.0, .heading_rad = std::numbers::pi / 2.0}}};
  const View view = robots.view();
  CHECK(rule.input(*perception::adversary(0, view), view) == -1.0);
  CHECK(rule.input(*perception::adversary(1, view), view) == 1.0);
}

TEST_CASE("side of adversary: straight ahead counts as right and straight behind as left") {
  const perception::sensors::SideOfAdversary rule;
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 2.0}}};
  CHECK(rule.input({.self = 0, .adversary = 1, .distance_m = 2.0, .bearing_rad = 0.0}, robots.view()) == 1.0);
  CHECK(rule.input({.self = 0, .adversary = 1, .distance_m = 2.0, .bearing_rad = -std::numbers::pi}, robots.view()) == -1.0);
  CHECK(rule.input({.self = 0, .adversary = 1, .distance_m = 2.0, .bearing_rad = 1e-9}, robots.view()) == 1.0);
  CHECK(rule.input({.self = 0, .adversary = 1, .distance_m = 2.0, .bearing_rad = -1e-9}, robots.view()) == -1.0);
}
