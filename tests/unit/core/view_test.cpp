// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("view: population -> counts, ages and hunger") {
  HandPopulation robots{
      {{.species = prey, .age_from_s = 10.0}, {.species = predator, .fed_tick = 4}, {.species = predator, .fed_tick = 20}},
      predator_prey_web()};
  const View view = robots.at_tick(20).view();
  CHECK(view.count(prey) == 1);
  CHECK(view.count(predator) == 2);
  CHECK(view.count_hunters() == 2);
  CHECK(view.age_s(view.robots[0]) == 30.0);
  CHECK(view.hunger_ticks(view.robots[1]) == 16);
  CHECK(view.hunger_ticks(view.robots[2]) == 0);
  const HandPopulation chain{{{.species = plant}, {.species = grazer}, {.species = hunter}}, chain_web()};
  CHECK(chain.view().count_hunters() == 2);
}

TEST_CASE("view: closest -> not itself, only accepted ones, lower body at equal distance") {
  const HandPopulation robots{
      {{.x_m = 0.0, .y_m = 0.0}, {.x_m = 3.0, .y_m = 4.0}, {.x_m = -3.0, .y_m = 4.0}, {.x_m = 0.0, .y_m = 6.0}}};
  const View view = robots.view();
  CHECK(view.distance_m(0, 1) == 5.0);
  CHECK(view.closest(0, [](const Individual&) { return true; }) == 1);
  CHECK(view.closest(0, [](const Individual& other) { return other.id != 1; }) == 2);
  CHECK(view.closest(0, [](const Individual& other) { return other.id == 3; }) == 3);
  CHECK(view.closest(0, [](const Individual& other) { return other.id == 0; }) == std::nullopt);
}

TEST_CASE("units: any angle -> wrapped into above -pi, up to pi") {
  CHECK(wrap_angle(0.5) == 0.5);
  CHECK(wrap_angle(std::numbers::pi) == std::numbers::pi);
  CHECK(wrap_angle(-std::numbers::pi) == std::numbers::pi);
  CHECK(wrap_angle(1.0 + 6.0 * std::numbers::pi) == doctest::Approx(1.0));
  CHECK(wrap_angle(-4.0) == doctest::Approx(2.0 * std::numbers::pi - 4.0));
}

TEST_CASE("units: target to the right -> positive bearing") {
  const GroundPose self{.x_m = 1.0, .y_m = 1.0, .heading_rad = std::numbers::pi / 2.0};
  CHECK(bearing_rad(self, {.x_m = 1.0, .y_m = 5.0}) == doctest::Approx(0.0));
  CHECK(bearing_rad(self, {.x_m = 2.0, .y_m = 1.0}) == doctest::Approx(std::numbers::pi / 2.0));
  CHECK(bearing_rad(self, {.x_m = 0.0, .y_m = 1.0}) == doctest::Approx(-std::numbers::pi / 2.0));
  CHECK(bearing_rad(self, {.x_m = 1.0, .y_m = 0.0}) == doctest::Approx(-std::numbers::pi));
}
