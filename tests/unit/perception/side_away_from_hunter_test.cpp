// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <numbers>
#include <optional>
#include <support/hand_population.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/perception/sensors/side_away_from_hunter.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("side away from hunter: predator on the left of prey, prey on the right of predator -> +1") {
  const perception::sensors::SideAwayFromHunter rule;
  // both face +y: the predator is on the prey's left and the prey on the predator's right
  HandPopulation robots{{{.species = prey, .x_m = 1.0, .heading_rad = std::numbers::pi / 2.0},
                         {.species = predator, .x_m = -1.0, .heading_rad = std::numbers::pi / 2.0}}};
  Rng rng{1, Stream::sensors};
  const auto seen_by = [&](BodyIndex self) {
    const auto sighting = perception::adversary(self, robots.view(), robots.perceives());
    REQUIRE(sighting);
    return rule.sense(self, sighting, robots.view(), rng)[0];
  };
  CHECK(seen_by(0) == 1.0);
  CHECK(seen_by(1) == 1.0);
  robots.poses[0].heading_rad = robots.poses[1].heading_rad = -std::numbers::pi / 2.0;
  CHECK(seen_by(0) == -1.0);
  CHECK(seen_by(1) == -1.0);
  CHECK(rule.sense(0, std::nullopt, robots.view(), rng)[0] == 0.0);
}

TEST_CASE("side away from hunter: middle species -> away from its predators, towards its prey") {
  const perception::sensors::SideAwayFromHunter rule;
  const HandPopulation robots{{{.species = plant}, {.species = grazer}, {.species = hunter}}, chain_web()};
  const auto input = [&](BodyIndex adversary) {
    Rng rng{1, Stream::sensors};
    const Sighting sighting{.self = 1, .adversary = adversary, .distance_m = 1.0, .bearing_rad = 0.5};
    return rule.sense(1, sighting, robots.view(), rng)[0];
  };
  CHECK(input(0) == 1.0);
  CHECK(input(2) == -1.0);
}

TEST_CASE("side away from hunter: straight ahead -> counts as right") {
  const perception::sensors::SideAwayFromHunter rule;
  const HandPopulation robots{{{.species = prey}, {.species = predator}}};
  const auto input = [&](double bearing_rad) {
    Rng rng{1, Stream::sensors};
    return rule.sense(1, Sighting{.self = 1, .adversary = 0, .distance_m = 1.0, .bearing_rad = bearing_rad}, robots.view(),
                      rng)[0];
  };
  CHECK(input(0.0) == input(0.5));
  CHECK(input(0.0) != input(-0.5));
}
