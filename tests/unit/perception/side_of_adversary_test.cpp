// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <numbers>
#include <optional>
#include <support/hand_population.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/perception/sensors/side_of_adversary.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("side of adversary: left -> -1, right -> +1, none -> 0, for prey and predators") {
  const perception::sensors::SideOfAdversary rule;
  // both face +y: what has a smaller x is on the left
  const HandPopulation robots{{{.species = prey, .x_m = 1.0, .heading_rad = std::numbers::pi / 2.0},
                               {.species = predator, .x_m = -1.0, .heading_rad = std::numbers::pi / 2.0}}};
  const View view = robots.view();
  Rng rng{1, Stream::sensors};
  CHECK(rule.sense(0, perception::adversary(0, view, robots.perceives()), view, rng)[0] == -1.0);
  CHECK(rule.sense(1, perception::adversary(1, view, robots.perceives()), view, rng)[0] == 1.0);
  CHECK(rule.sense(0, std::nullopt, view, rng)[0] == 0.0);
}

TEST_CASE("side of adversary: straight ahead -> right, straight behind -> left") {
  const perception::sensors::SideOfAdversary rule;
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 2.0}}};
  const auto side = [&](double bearing_rad) {
    Rng rng{1, Stream::sensors};
    const Sighting sighting{.self = 0, .adversary = 1, .distance_m = 2.0, .bearing_rad = bearing_rad};
    return rule.sense(0, sighting, robots.view(), rng)[0];
  };
  CHECK(side(0.0) == 1.0);
  CHECK(side(-std::numbers::pi) == -1.0);
  CHECK(side(1e-9) == 1.0);
  CHECK(side(-1e-9) == -1.0);
}
