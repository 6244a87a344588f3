// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <support/hand_population.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/perception/sensors/distance_over_diagonal.hpp>
#include <trophic/perception/sensors/distance_over_scale.hpp>
#include <trophic/perception/sensors/distance_over_terrain.hpp>
#include <trophic/perception/sensors/side_away_from_hunter.hpp>
#include <trophic/perception/sensors/side_of_adversary.hpp>
#include <trophic/perception/sensors/tag_ratio_of_active.hpp>
#include <trophic/perception/sensors/tag_ratio_of_all.hpp>

using namespace trophic;
using namespace trophic::test;

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

namespace {

double ratio_of(const perception::sensors::TagRatioOfActive& rule, const View& view) {
  return rule.sense(view)[0];
}

}  // namespace

TEST_CASE("tag ratio of active: inactive newborn -> not counted") {
  const perception::sensors::TagRatioOfActive rule;
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = 1}, {.tag = 1}, {.tag = -1}}}.view()) == 0.25);
  CHECK(ratio_of(rule,
                 HandPopulation{{{.tag = 1}, {.tag = 1, .active = false}, {.tag = -1}, {.tag = -1, .active = false}}}.view()) ==
        0.0);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = -1, .active = false}}}.view()) == 0.5);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = -1}, {.tag = 1, .active = false}}}.view()) == -0.5);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1, .active = false}}}.view()) == 0.0);
}

TEST_CASE("tag ratio of active: random populations -> within +-1/2, odd in all tags, any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    const perception::sensors::TagRatioOfActive rule;
    HandPopulation robots = random_population(seed, 1 + seed % 30);
    const double ratio = ratio_of(rule, robots.view());
    RC_ASSERT(std::abs(ratio) <= 0.5);
    RC_ASSERT(ratio_of(rule, robots.reordered(random_order(seed, robots.individuals.size())).view()) == ratio);
    for (Individual& individual : robots.individuals) individual.tag = -individual.tag;
    RC_ASSERT(ratio_of(rule, robots.view()) == -ratio);
  }));
}

namespace {

double ratio_of(const perception::sensors::TagRatioOfAll& rule, const View& view) {
  return rule.sense(view)[0];
}

}  // namespace

TEST_CASE("tag ratio of all: P of N robots tagged +1 -> (P - N/2) / N, inactive newborn included") {
  const perception::sensors::TagRatioOfAll rule;
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = 1}, {.tag = 1}, {.tag = -1}}}.view()) == 0.25);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = -1}, {.tag = -1, .active = false}, {.tag = -1}}}.view()) == -0.25);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = -1}}}.view()) == 0.0);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}}}.view()) == 0.5);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = -1}, {.tag = -1}}}.view()) == -0.5);
}

TEST_CASE("tag ratio of all: random populations -> within +-1/2, odd in all tags, any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    const perception::sensors::TagRatioOfAll rule;
    HandPopulation robots = random_population(seed, 1 + seed % 30);
    const double ratio = ratio_of(rule, robots.view());
    RC_ASSERT(std::abs(ratio) <= 0.5);
    RC_ASSERT(ratio_of(rule, robots.reordered(random_order(seed, robots.individuals.size())).view()) == ratio);
    for (Individual& individual : robots.individuals) individual.tag = -individual.tag;
    RC_ASSERT(ratio_of(rule, robots.view()) == -ratio);
  }));
}
