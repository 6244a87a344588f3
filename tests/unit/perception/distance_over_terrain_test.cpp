// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <support/hand_population.hpp>
#include <trophic/perception/sensors/distance_over_terrain.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("distance over terrain: the arena's extent or more, or no adversary -> 1") {
  const perception::sensors::DistanceOverTerrain rule;
  HandPopulation robots{{}};
  Rng rng{1, Stream::sensors};
  const auto input = [&](double distance_m) { return rule.sense(0, Sighting{.distance_m = distance_m}, robots.view(), rng)[0]; };
  CHECK(input(0.0) == 0.0);
  CHECK(input(5.0) == 0.25);
  CHECK(input(20.0) == 1.0);
  CHECK(input(28.0) == 1.0);
  robots.arena.extent_m = 50.0;
  CHECK(input(5.0) == 0.1);
  CHECK(rule.sense(0, std::nullopt, robots.view(), rng)[0] == 1.0);
}
