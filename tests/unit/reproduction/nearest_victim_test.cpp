// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <optional>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>

using namespace trophic;
using namespace trophic::test;

namespace {

std::optional<IndividualId> parent_of(BodyIndex body, const HandPopulation& robots,
                                      const reproduction::parent::NearestVictim& rule = {}) {
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = body, .cause = Cause::starved, .killer = {}}, robots.view(), rng);
  return parent ? std::optional{parent->id} : std::nullopt;
}

}  // namespace

TEST_CASE("nearest victim: any tags and activity -> closest prey") {
  const HandPopulation robots{{{.species = predator},
                               {.species = prey, .x_m = 3.0, .tag = 1},
                               {.species = prey, .y_m = -2.0, .tag = -1, .active = false},
                               {.species = predator, .x_m = 0.5}}};
  CHECK(parent_of(0, robots) == 2);
}

TEST_CASE("nearest victim: distance equal to the range -> within it") {
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 4.0}}};
  CHECK(parent_of(0, robots) == 1);
  robots.poses[1].x_m = 4.0000001;
  CHECK(parent_of(0, robots) == std::nullopt);
  CHECK(parent_of(0, robots, {{.range_m = 5.0}}) == 1);
}

TEST_CASE("nearest victim: equal distance -> lower body, no prey -> none") {
  CHECK(parent_of(1, HandPopulation{{{.species = prey, .x_m = -1.0}, {.species = predator}, {.species = prey, .x_m = 1.0}}}) ==
        0);
  CHECK(parent_of(0, HandPopulation{{{.species = predator}, {.species = predator, .x_m = 1.0}}}) == std::nullopt);
}

TEST_CASE("nearest victim: food chain -> only species that the dead individual ate") {
  const HandPopulation robots{{{.species = plant, .x_m = 2.0}, {.species = grazer, .x_m = 1.0}, {.species = hunter}},
                              chain_web()};
  CHECK(parent_of(2, robots) == 1);
  CHECK(parent_of(1, robots) == 0);
  CHECK(parent_of(0, robots) == std::nullopt);
}

TEST_CASE("nearest victim: random populations -> closest prey, any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 15);
    const auto order = random_order(seed, 15);
    const HandPopulation moved = robots.reordered(order);
    for (BodyIndex body = 0; body < 15; ++body) {
      const auto parent = parent_of(order[body], robots);
      RC_ASSERT(parent == parent_of(body, moved));
      bool any_in_range = false;
      for (BodyIndex other = 0; other < 15; ++other) {
        const bool eaten = robots.web.eats(robots.individuals[order[body]].species, robots.individuals[other].species);
        any_in_range = any_in_range || (eaten && robots.view().distance_m(order[body], other) <= 4.0);
      }
      RC_ASSERT(parent.has_value() == any_in_range);
    }
  }));
}
