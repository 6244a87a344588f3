// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <optional>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/nearest_active_victim.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>

using namespace trophic;
using namespace trophic::test;

namespace {

template <class Rule>
std::optional<IndividualId> parent_by(const Rule& rule, BodyIndex body, const HandPopulation& robots) {
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = body, .cause = Cause::starved, .killer = {}}, robots.view(), rng);
  return parent ? std::optional{parent->id} : std::nullopt;
}

using reproduction::parent::NearestActiveVictim;
using reproduction::parent::NearestVictim;

}  // namespace

TEST_CASE("nearest active victim: an inactive prey is closer -> the closest active prey, whatever the tags") {
  const HandPopulation robots{{{.species = predator},
                               {.species = prey, .x_m = 3.0, .tag = 1},
                               {.species = prey, .y_m = -2.0, .tag = -1, .active = false},
                               {.species = predator, .x_m = 0.5}}};
  CHECK(parent_by(NearestActiveVictim{}, 0, robots) == 1);
  CHECK(parent_by(NearestVictim{}, 0, robots) == 2);
}

TEST_CASE("nearest active victim: only inactive prey -> none") {
  CHECK(parent_by(NearestActiveVictim{}, 0, HandPopulation{{{.species = predator}, {.species = prey, .active = false}}}) ==
        std::nullopt);
}

TEST_CASE("nearest active victim: distance equal to the range -> within it") {
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 12.0}}};
  CHECK(parent_by(NearestActiveVictim{}, 0, robots) == 1);
  robots.poses[1].x_m = 12.0000001;
  CHECK(parent_by(NearestActiveVictim{}, 0, robots) == std::nullopt);
  CHECK(parent_by(NearestActiveVictim{{.range_m = 13.0}}, 0, robots) == 1);
}

TEST_CASE("nearest active victim: all active -> as nearest victim, in any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    HandPopulation robots = random_population(seed, 15);
    for (Individual& individual : robots.individuals) individual.active = true;
    const auto order = random_order(seed, 15);
    const HandPopulation moved = robots.reordered(order);
    for (BodyIndex body = 0; body < 15; ++body) {
      const auto parent = parent_by(NearestActiveVictim{{.range_m = 4.0}}, order[body], robots);
      RC_ASSERT(parent == parent_by(NearestVictim{{.range_m = 4.0}}, order[body], robots));
      RC_ASSERT(parent == parent_by(NearestActiveVictim{{.range_m = 4.0}}, body, moved));
    }
  }));
}
