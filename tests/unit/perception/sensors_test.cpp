// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <support/hand_population.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/perception/sensors/dealt.hpp>
#include <trophic/perception/sensors/distance_over_diagonal.hpp>
#include <trophic/perception/sensors/distance_over_scale.hpp>
#include <trophic/perception/sensors/distance_over_terrain.hpp>
#include <trophic/perception/sensors/food_gradient.hpp>
#include <trophic/perception/sensors/hearing.hpp>
#include <trophic/perception/sensors/nearest_zone.hpp>
#include <trophic/perception/sensors/own_energy.hpp>
#include <trophic/perception/sensors/own_speed.hpp>
#include <trophic/perception/sensors/random_turn.hpp>
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

template <class Rule>
double ratio_of(const Rule& rule, const View& view) {
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

TEST_CASE_TEMPLATE("tag ratio: random populations -> within +-1/2, odd in all tags, any order of bodies", Rule,
                   perception::sensors::TagRatioOfActive, perception::sensors::TagRatioOfAll) {
  CHECK(rc::check([](std::uint64_t seed) {
    const Rule rule;
    HandPopulation robots = random_population(seed, 1 + seed % 30);
    const double ratio = ratio_of(rule, robots.view());
    RC_ASSERT(std::abs(ratio) <= 0.5);
    RC_ASSERT(ratio_of(rule, robots.reordered(random_order(seed, robots.individuals.size())).view()) == ratio);
    for (Individual& individual : robots.individuals) individual.tag = -individual.tag;
    RC_ASSERT(ratio_of(rule, robots.view()) == -ratio);
  }));
}

TEST_CASE("tag ratio of all: P of N robots tagged +1 -> (P - N/2) / N, inactive newborn included") {
  const perception::sensors::TagRatioOfAll rule;
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = 1}, {.tag = 1}, {.tag = -1}}}.view()) == 0.25);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = -1}, {.tag = -1, .active = false}, {.tag = -1}}}.view()) == -0.25);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = -1}}}.view()) == 0.0);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}}}.view()) == 0.5);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = -1}, {.tag = -1}}}.view()) == -0.5);
}

namespace {

template <class Sensor>
auto values_of(const Sensor& sensor, const View& view, BodyIndex self = 0) {
  Rng rng{1, Stream::user};
  return sensor.sense(self, std::nullopt, view, rng);
}

}  // namespace

TEST_CASE("hearing: calls on the channel -> the loudest in each sector, less with distance") {
  const test::HandPopulation robots{{{.heading_rad = 0.0},
                                     {.x_m = 1.0, .y_m = 0.5},
                                     {.x_m = 2.0, .y_m = 0.5},
                                     {.x_m = -1.0, .y_m = -0.5},
                                     {.x_m = 1.0, .y_m = -9.0}}};
  const char* const key = &detail::act_key<control::acts::Signal<1>>;
  const std::vector<double> signals{1.0, 0.2, 0.8, 0.5, 1.0};
  View view = robots.view();
  view.acts = {.acts = {&key, 1}, .values = signals};
  const perception::sensors::Hearing<1, 4> ears{{.range_m = 8.0}};
  // from the left of straight behind: behind left, ahead left, ahead right, behind right
  const auto heard = values_of(ears, view);
  CHECK(heard[0] == 0.0);
  CHECK(heard[1] == doctest::Approx(0.8 * (1.0 - std::sqrt(4.25) / 8.0)));
  CHECK(heard[2] == 0.0);
  CHECK(heard[3] == doctest::Approx(0.5 * (1.0 - std::sqrt(1.25) / 8.0)));
  CHECK(values_of(perception::sensors::Hearing<2, 4>{}, view) == std::array<double, 4>{});
}

TEST_CASE("food gradient: four cells around -> shares ahead and to the right, 0 without food") {
  test::HandPopulation robots{{{.x_m = 0.5, .y_m = 0.5, .heading_rad = std::numbers::pi / 2.0}}};
  ResourceField field{robots.arena, 20};
  View view = robots.view();
  const perception::sensors::FoodGradient nose{{.reach_m = 1.0}};
  CHECK(values_of(nose, view) == std::array{0.0, 0.0});
  view.foods = {&field, 1};
  CHECK(values_of(nose, view) == std::array{0.0, 0.0});
  field.food_J(field.cell_at(0.5, 1.5)) = 3.0;   // ahead
  field.food_J(field.cell_at(0.5, -0.5)) = 1.0;  // behind
  field.food_J(field.cell_at(-0.5, 0.5)) = 4.0;  // left
  CHECK(values_of(nose, view) == std::array{0.25, -0.5});
}

TEST_CASE("nearest zone: ahead, right and distance, over the edges of a torus, and without a zone") {
  test::HandPopulation robots{{{.x_m = -9.0, .y_m = 0.5, .heading_rad = std::numbers::pi / 2.0}}};
  ResourceField field{robots.arena, 20};
  field.set_zone(field.cell_at(9.5, 0.5), 2.0);
  View view = robots.view();
  const perception::sensors::NearestZone sensor;
  CHECK(values_of(sensor, view) == std::array{0.0, 0.0, 1.0});
  view.foods = {&field, 1};
  const auto there = values_of(sensor, view);
  CHECK(there[0] == doctest::Approx(0.0));
  CHECK(there[1] == doctest::Approx(1.0));
  CHECK(there[2] == 1.0);
  view.space.period_m = 20.0;
  const auto across = values_of(sensor, view);
  CHECK(across[1] == doctest::Approx(-1.0));
  CHECK(across[2] == doctest::Approx(0.15));
  field.set_zone(field.cell_at(-8.5, 0.5), 2.0);
  CHECK(values_of(sensor, view)[2] == doctest::Approx(0.05));
}

TEST_CASE("own energy: share of the scale, from 0 to 1") {
  test::HandPopulation robots{{{}}};
  const perception::sensors::OwnEnergy own{{.full_scale_J = 50.0}};
  for (const auto& [energy_J, value] : std::vector<std::pair<double, double>>{{-1.0, 0.0}, {20.0, 0.4}, {80.0, 1.0}}) {
    robots.individuals[0].energy_J = energy_J;
    CHECK(values_of(own, robots.view())[0] == value);
  }
}

TEST_CASE("own speed: distance of the last tick over its length and the scale") {
  const test::HandPopulation robots{{{}}};
  const perception::sensors::OwnSpeed own{{.full_scale_m_s = 0.1}};
  perception::sensors::OwnSpeed::State state;
  Rng rng{1, Stream::user};
  CHECK(own.sense(0, std::nullopt, robots.view(), rng, state)[0] == 0.0);
  own.on_walk(state, 0, 0.1, robots.view());
  CHECK(own.sense(0, std::nullopt, robots.view(), rng, state)[0] == doctest::Approx(0.5));
}

TEST_CASE("dealt: values of a random robot of the species, each as often") {
  test::HandPopulation robots{{{.species = prey}, {.species = predator}, {.species = prey}, {.species = prey}}};
  for (BodyIndex body = 0; body < 4; ++body) robots.individuals[body].energy_J = 10.0 * static_cast<double>(body);
  const perception::sensors::Dealt<perception::sensors::OwnEnergy> dealt{{.sensed = {.full_scale_J = 100.0}}};
  std::array<int, 4> drawn{};
  Rng rng{2, Stream::user};
  for (int i = 0; i < 3000; ++i)
    ++drawn.at(static_cast<std::size_t>(std::lround(10.0 * dealt.sense(0, std::nullopt, robots.view(), rng)[0])));
  CHECK(drawn[1] == 0);
  for (const BodyIndex body : {BodyIndex{0}, BodyIndex{2}, BodyIndex{3}}) CHECK(std::abs(drawn[body] - 1000) < 100);
}

TEST_CASE("random turn: many -> within 1 of 0, without bias, variance of a difference of uniform numbers") {
  const HandPopulation robots{{{}}};
  Rng rng{1, Stream::sensors};
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    const double turn = perception::sensors::RandomTurn{}.sense(0, {}, robots.view(), rng)[0];
    CHECK(std::abs(turn) < 1.0);
    sum += turn;
    squares += turn * turn;
  }
  CHECK(std::abs(sum) < 200.0);
  CHECK(squares / 10'000.0 == doctest::Approx(1.0 / 6.0).epsilon(0.05));
}
