// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <set>
#include <support/hand_population.hpp>
#include <trophic/death/capture/catch_within_reach.hpp>

using namespace trophic;
using namespace trophic::test;
using death::Capture;
using death::capture::CatchWithinReach;
using Captures = std::vector<Capture>;

namespace {

Captures captures(const HandPopulation& robots, const CatchWithinReach& rule = {}) {
  Rng rng{1, Stream::captures};
  return rule.captures(robots.view(), rng);
}

}  // namespace

TEST_CASE("catch within reach: at exactly 1 m, any tags -> caught, beyond -> not") {
  HandPopulation robots{{{.species = predator, .tag = 1}, {.species = prey, .x_m = 1.0, .tag = -1}}};
  CHECK(captures(robots) == Captures{{0, 1}});
  robots.poses[1].x_m = 1.0000001;
  CHECK(captures(robots).empty());
  CHECK(captures(robots, {{.reach_m = 2.0}}) == Captures{{0, 1}});
}

TEST_CASE("catch within reach: inactive newborn -> not caught") {
  CHECK(captures(HandPopulation{{{.species = predator}, {.species = prey, .active = false}}}).empty());
}

TEST_CASE("catch within reach: several predators -> the closest catches, at equal distance the lower body") {
  CHECK(captures(HandPopulation{{{.species = predator, .x_m = -0.9}, {.species = prey}, {.species = predator, .x_m = 0.4}}}) ==
        Captures{{2, 1}});
  CHECK(captures(HandPopulation{{{.species = predator, .x_m = -0.5}, {.species = prey}, {.species = predator, .x_m = 0.5}}}) ==
        Captures{{0, 1}});
}

TEST_CASE("catch within reach: several prey in reach -> all caught, the closest first") {
  CHECK(captures(HandPopulation{{{.species = prey, .x_m = 0.8},
                                 {.species = prey, .x_m = -0.2},
                                 {.species = predator},
                                 {.species = prey, .x_m = 0.3},
                                 {.species = prey, .x_m = 1.5}}}) == Captures{{2, 1}, {2, 3}, {2, 0}});
}

TEST_CASE("catch within reach: hunter younger than min_age -> no catch, at exactly min_age -> catch") {
  HandPopulation robots{{{.species = predator, .age_from_s = 100.0}, {.species = prey}}};
  CHECK(captures(robots.at_tick(50)) == Captures{{0, 1}});
  CHECK(captures(robots.at_tick(59), {{.min_age_s = 20.0}}).empty());
  CHECK(captures(robots.at_tick(60), {{.min_age_s = 20.0}}) == Captures{{0, 1}});
}

TEST_CASE("catch within reach: no prey, no predators or no robots -> no catch") {
  CHECK(captures(HandPopulation{{}}).empty());
  CHECK(captures(HandPopulation{{{.species = prey}, {.species = prey}}}).empty());
  CHECK(captures(HandPopulation{{{.species = predator}, {.species = predator}}}).empty());
}

TEST_CASE("catch within reach: food chain -> middle species catches and is caught, ends do not interact") {
  const HandPopulation robots{
      {{.species = hunter}, {.species = grazer, .x_m = 0.5}, {.species = plant, .x_m = 0.7}, {.species = plant, .x_m = -0.1}},
      chain_web()};
  CHECK(captures(robots) == Captures{{1, 2}, {0, 1}, {1, 3}});
}

TEST_CASE(
    "catch within reach: each victim once and by its closest hunter, all in reach, and the order of bodies does not matter") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 20, chain_web(), 2.0);
    const View view = robots.view();
    const Captures result = captures(robots);
    std::set<BodyIndex> victims;
    for (const auto& [hunter_body, victim] : result) {
      RC_ASSERT(victims.insert(victim).second);
      RC_ASSERT(view.web.eats(view.robots[hunter_body].species, view.robots[victim].species));
      RC_ASSERT(view.robots[victim].active);
      for (BodyIndex other = 0; other < 20; ++other) {
        if (view.web.eats(view.robots[other].species, view.robots[victim].species)) {
          RC_ASSERT(view.distance_m(other, victim) >= view.distance_m(hunter_body, victim));
        }
      }
      RC_ASSERT(view.distance_m(hunter_body, victim) <= 1.0);
    }
    for (BodyIndex a = 0; a < 20; ++a) {
      for (BodyIndex b = 0; b < 20; ++b) {
        const bool can = view.web.eats(view.robots[a].species, view.robots[b].species) && view.robots[b].active;
        if (can && view.distance_m(a, b) <= 1.0) RC_ASSERT(victims.contains(b));
      }
    }
    const auto order = random_order(seed, 20);
    Captures moved = captures(robots.reordered(order));
    for (Capture& capture : moved) capture = {order[capture.hunter], order[capture.victim]};
    RC_ASSERT(moved == result);
  }));
}
