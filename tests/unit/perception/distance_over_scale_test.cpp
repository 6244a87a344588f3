// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <support/hand_population.hpp>
#include <trophic/perception/sensors/distance_over_scale.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("distance over scale: 20 m or more, or no adversary -> 1 in any arena") {
  HandPopulation robots{{}};
  robots.arena.extent_m = 24.0;
  const auto input = [&](const perception::sensors::DistanceOverScale& rule, double distance_m) {
    Rng rng{1, Stream::sensors};
    return rule.sense(0, Sighting{.distance_m = distance_m}, robots.view(), rng)[0];
  };
  CHECK(input({}, 0.0) == 0.0);
  CHECK(input({}, 5.0) == 0.25);
  CHECK(input({}, 20.0) == 1.0);
  CHECK(input({}, 33.0) == 1.0);
  CHECK(input({{.full_scale_m = 10.0}}, 5.0) == 0.5);
  Rng rng{1, Stream::sensors};
  CHECK(perception::sensors::DistanceOverScale{}.sense(0, std::nullopt, robots.view(), rng)[0] == 1.0);
}
