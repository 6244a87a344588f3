// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <support/hand_population.hpp>
#include <trophic/death/capture/one_within_reach.hpp>

using namespace trophic;
using namespace trophic::test;
using death::Capture;
using death::capture::OneWithinReach;

namespace {

std::vector<Capture> captures(HandPopulation robots, const std::vector<OneWithinReach::State>& states, std::uint64_t seed = 1) {
  Rng rng{seed, Stream::captures};
  return OneWithinReach{{.reach_m = 1.0}}.captures(robots.at_tick(7).view(), rng, states);
}

}  // namespace

TEST_CASE("one within reach: several victims -> the closest active one, one for each hunter") {
  const HandPopulation robots{{{.species = predator},
                               {.species = prey, .x_m = 0.1, .active = false},
                               {.species = prey, .x_m = 0.5},
                               {.species = prey, .x_m = 0.3},
                               {.species = prey, .x_m = 1.1},
                               {.species = predator, .x_m = 9.0}}};
  CHECK(captures(robots, std::vector<OneWithinReach::State>(6)) == std::vector{Capture{0, 3}});
}

TEST_CASE("one within reach: two hunters of one victim -> either is first, the other gets the next or none") {
  HandPopulation robots{{{.species = predator}, {.species = predator, .x_m = 0.2}, {.species = prey, .x_m = 0.5}}};
  std::set<BodyIndex> catchers;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto caught = captures(robots, std::vector<OneWithinReach::State>(3), seed);
    REQUIRE(caught.size() == 1);
    catchers.insert(caught[0].hunter);
  }
  CHECK(catchers.size() == 2);
}

TEST_CASE("one within reach: after a catch -> no hunting for so many ticks") {
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 0.5}}};
  const OneWithinReach rule{{.reach_m = 1.0, .handling_ticks = 3}};
  OneWithinReach::State own = rule.born(robots.individuals[0], nullptr, {});
  CHECK(captures(robots, {own, {}}).size() == 1);
  rule.on_catch(own, 0, 1, robots.at_tick(4).view());
  CHECK(captures(robots, {own, {}}).empty());
  own.busy_until_tick = 6;
  CHECK(captures(robots, {own, {}}).size() == 1);
}
