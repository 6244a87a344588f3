// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/sensors/distance_over_scale.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("distance over scale: 20 m is 1 in any arena and all beyond it") {
  HandPopulation robots{{}};
  robots.arena.extent_m = 24.0;
  const auto input = [&](const perception::sensors::DistanceOverScale& rule, double distance_m) {
    return rule.input({.distance_m = distance_m}, robots.view());
  };
  CHECK(input({}, 0.0) == 0.0);
  CHECK(input({}, 5.0) == 0.25);
  CHECK(input({}, 20.0) == 1.0);
  CHECK(input({}, 33.0) == 1.0);
  CHECK(input({{.full_scale_m = 10.0}}, 5.0) == 0.5);
}
