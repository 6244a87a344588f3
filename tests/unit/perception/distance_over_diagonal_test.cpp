// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <numbers>
#include <optional>
#include <support/hand_population.hpp>
#include <trophic/perception/sensors/distance_over_diagonal.hpp>

using namespace trophic;

TEST_CASE(
    "distance over diagonal: distance and extent -> a fraction of sqrt(2) times the extent, 1 beyond it and without adversary") {
  const perception::sensors::DistanceOverDiagonal rule;
  struct Case {
    double extent_m, distance_m, input;
  };
  test::HandPopulation robots{{{}}};
  Rng rng{1, Stream::sensors};
  for (const auto& [extent_m, distance_m, input] :
       {Case{20.0, 0.0, 0.0}, Case{20.0, 20.0, 0.7071067811865475}, Case{20.0, 20.0 * std::numbers::sqrt2, 1.0},
        Case{20.0, 28.0, 0.9899494936611665}, Case{20.0, 40.0, 1.0}, Case{50.0, 20.0, 0.282842712474619}}) {
    CAPTURE(distance_m);
    robots.arena.extent_m = extent_m;
    CHECK(rule.sense(0, Sighting{.distance_m = distance_m}, robots.view(), rng)[0] == doctest::Approx(input).epsilon(1e-12));
  }
  CHECK(rule.sense(0, std::nullopt, robots.view(), rng)[0] == 1.0);
}
