// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <support/hand_population.hpp>
#include <trophic/perception/adversary.hpp>

using namespace trophic;
using namespace trophic::test;

namespace {

std::optional<Sighting> seen(BodyIndex self, const HandPopulation& robots) {
  return perception::adversary(self, robots.view(), robots.perceives());
}

}  // namespace

TEST_CASE("adversary: closest opponent has another tag -> closest with the same tag") {
  const HandPopulation robots{{{.species = prey, .x_m = 1.0, .y_m = 1.0},
                               {.species = predator, .x_m = 1.5, .y_m = 1.0, .tag = -1},
                               {.species = predator, .x_m = 1.0, .y_m = 5.0},
                               {.species = predator, .x_m = 4.0, .y_m = 5.0},
                               {.species = prey, .x_m = 1.1, .y_m = 1.0}}};
  const auto found = seen(0, robots);
  REQUIRE(found);
  CHECK(found->self == 0);
  CHECK(found->adversary == 2);
  CHECK(found->distance_m == 4.0);
  CHECK(found->bearing_rad == doctest::Approx(-std::numbers::pi / 2.0));
  CHECK(seen(1, robots) == std::nullopt);
  CHECK(seen(2, robots)->adversary == 0);  // exactly 4 m away, body 4 is sqrt(16.01) m away
}

TEST_CASE("adversary: bearing -> relative to its own heading, positive to the right") {
  HandPopulation robots{{{.species = prey, .heading_rad = std::numbers::pi / 2.0}, {.species = predator, .x_m = 3.0}}};
  CHECK(seen(0, robots)->bearing_rad == doctest::Approx(std::numbers::pi / 2.0));
  CHECK(seen(1, robots)->bearing_rad == doctest::Approx(-std::numbers::pi));
  robots.poses[0].heading_rad = -std::numbers::pi / 2.0;
  CHECK(seen(0, robots)->bearing_rad == doctest::Approx(-std::numbers::pi / 2.0));
  robots.poses[0].heading_rad = 0.0;
  CHECK(seen(0, robots)->bearing_rad == 0.0);
}

TEST_CASE("adversary: inactive newborn -> perceives hunters, not perceived by them") {
  const HandPopulation robots{{{.species = prey, .active = false}, {.species = predator, .x_m = 2.0}}};
  CHECK(seen(0, robots)->adversary == 1);
  CHECK_FALSE(seen(1, robots));
}

TEST_CASE("adversary: equal distance -> lower body") {
  const HandPopulation robots{
      {{.species = predator, .x_m = -2.0}, {.species = prey}, {.species = predator, .x_m = 2.0}, {.species = prey, .x_m = 4.0}}};
  CHECK(seen(1, robots)->adversary == 0);
  CHECK(seen(2, robots)->adversary == 1);
}

TEST_CASE("adversary: no visible opponent -> none") {
  CHECK_FALSE(seen(0, HandPopulation{{{.species = prey}}}));
  CHECK_FALSE(seen(0, HandPopulation{{{.species = prey}, {.species = prey, .x_m = 1.0}}}));
}

TEST_CASE("adversary: middle species of a food chain -> above or below it") {
  HandPopulation robots{{{.species = plant, .x_m = 3.0}, {.species = grazer}, {.species = hunter, .x_m = -2.0}}, chain_web()};
  CHECK(seen(1, robots)->adversary == 2);
  CHECK(seen(0, robots)->adversary == 1);
  CHECK(seen(2, robots)->adversary == 1);
  robots.poses[0].x_m = 1.0;
  CHECK(seen(1, robots)->adversary == 0);
  CHECK(seen(2, robots)->adversary == 1);  // the plant is no opponent of the hunter
}

TEST_CASE("adversary: random populations -> closest visible opponent, any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 12, chain_web());
    const auto order = random_order(seed, 12);
    const HandPopulation moved = robots.reordered(order);
    const View view = robots.view();
    for (BodyIndex body = 0; body < 12; ++body) {
      const auto found = seen(order[body], robots);
      const auto found_moved = seen(body, moved);
      RC_ASSERT(found.has_value() == found_moved.has_value());
      if (!found) continue;
      RC_ASSERT(view.robots[found->adversary].id == moved.individuals[found_moved->adversary].id);
      RC_ASSERT(found->bearing_rad == found_moved->bearing_rad);
      RC_ASSERT((found->bearing_rad >= -std::numbers::pi && found->bearing_rad < std::numbers::pi));
      for (BodyIndex other = 0; other < 12; ++other) {
        const bool opponent = view.web.opponents(view.robots[order[body]].species, view.robots[other].species);
        const bool visible = opponent && robots.perceives()(order[body], other);
        if (other == found->adversary) RC_ASSERT(visible);
        if (visible) RC_ASSERT(view.distance_m(order[body], other) >= found->distance_m);
      }
    }
  }));
}
