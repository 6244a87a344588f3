// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/initialization/community/predator_prey.hpp>
#include <trophic/reproduction/recruitment/by_chance.hpp>
#include <trophic/rules/by_species.hpp>

using namespace trophic;
using namespace trophic::test;
using reproduction::recruitment::ByChance;

TEST_CASE(
    "by chance: many individuals -> so many births, a share of the energy, one step away within the arena or over its edge") {
  HandPopulation robots = random_population(1, 4000, predator_prey_web(), 10.0);
  Rng rng{1, Stream::user};
  const auto births = ByChance{{.chance = 0.25, .share = 0.5, .step_m = 1.0}}.recruits(robots.view(), rng);
  CHECK(births.size() == doctest::Approx(1000.0).epsilon(0.08));
  View torus = robots.view();
  torus.space.period_m = 2.0 * robots.arena.half_side_m;
  Rng again{1, Stream::user};
  const auto wrapped = ByChance{{.chance = 0.25, .share = 0.5, .step_m = 1.0}}.recruits(torus, again);
  REQUIRE(wrapped.size() == births.size());
  for (std::size_t i = 0; i < births.size(); ++i) {
    const BodyIndex parent = 1000 - births[i].parents.front().id;
    CHECK(births[i].endowment_J == std::max(0.0, robots.individuals[parent].energy_J / 2.0));
    CHECK(std::abs(births[i].place->x_m) <= 10.0);
    CHECK(distance_m(*births[i].place, robots.poses[parent]) <= 1.0 + 1e-9);
    CHECK(torus.distance_m(*wrapped[i].place, robots.poses[parent]) == doctest::Approx(1.0));
  }
}

TEST_CASE("by chance: by species -> each species' own births, spare bodies summed") {
  using Rule = rules::by_species<ByChance, initialization::community::PredatorPrey>;
  Rule::Params params;
  params.get<prey>() = {.spare_bodies = 3, .chance = 0.0};
  params.get<predator>() = {.spare_bodies = 4, .chance = 1.0, .share = 0.25};
  const Rule rule{params};
  CHECK(reproduction::ask::spare_bodies(rule) == 7);
  HandPopulation robots = with_predators(5);
  Rng rng{1, Stream::user};
  const auto births = reproduction::ask::recruits(rule, {}, robots.at_tick(1).view(), rng);
  REQUIRE(births.size() == 5);
  for (const auto& birth : births) CHECK(birth.species == predator);
}
