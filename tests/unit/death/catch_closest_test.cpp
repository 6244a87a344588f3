// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>
#include <set>
#include <support/hand_population.hpp>
#include <support/statistics.hpp>
#include <trophic/death/capture/catch_closest.hpp>

using namespace trophic;
using namespace trophic::test;
using death::Capture;
using death::capture::CatchClosest;
using Captures = std::vector<Capture>;

namespace {

/// At tick 100, with everybody old enough.
Captures captures_of(HandPopulation robots, std::uint64_t seed = 1, const CatchClosest& rule = {}) {
  Rng rng{seed, Stream::captures};
  return rule.captures(robots.at_tick(100).view(), rng);
}

}  // namespace

TEST_CASE("catch closest: closer than 1 m, any tags -> caught, at exactly 1 m -> not") {
  HandPopulation robots{{{.species = predator, .tag = 1}, {.species = prey, .x_m = 0.9999999, .tag = -1}}};
  CHECK(captures_of(robots) == Captures{{0, 1}});
  robots.poses[1].x_m = 1.0;
  CHECK(captures_of(robots).empty());
}

TEST_CASE("catch closest: several prey in reach -> only the closest active one") {
  CHECK(captures_of(HandPopulation{{{.species = predator},
                                    {.species = prey, .x_m = 0.1, .active = false},
                                    {.species = prey, .x_m = 0.5},
                                    {.species = prey, .x_m = -0.3}}}) == Captures{{0, 3}});
}

TEST_CASE("catch closest: equal distance -> the prey in the lower body") {
  CHECK(captures_of(HandPopulation{{{.species = prey, .x_m = 0.5}, {.species = predator}, {.species = prey, .x_m = -0.5}}}) ==
        Captures{{1, 0}});
}

TEST_CASE("catch closest: hunter younger than 20 s -> no catch, at exactly 20 s -> catch") {
  HandPopulation robots{{{.species = predator, .age_from_s = 100.0}, {.species = prey}}};
  const auto caught_at = [&](std::int64_t tick) {
    Rng rng{1, Stream::captures};
    return CatchClosest{}.captures(robots.at_tick(tick).view(), rng).size();
  };
  CHECK(caught_at(59) == 0);
  CHECK(caught_at(60) == 1);
}

TEST_CASE("catch closest: hunter caught itself -> others keep their turns") {
  // body 0 catches 1, a hunter of its own kind of prey; 2 catches 3 whoever comes first
  const HandPopulation robots{
      {{.species = hunter}, {.species = grazer, .x_m = 0.3}, {.species = grazer, .x_m = 5.0}, {.species = plant, .x_m = 5.3}},
      chain_web()};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Captures captures = captures_of(robots, seed);
    std::ranges::sort(captures, {}, &Capture::hunter);
    CHECK(captures == Captures{{0, 1}, {2, 3}});
  }
}

TEST_CASE("catch closest: no prey, no predators or no robots -> no catch") {
  CHECK(captures_of(HandPopulation{{}}).empty());
  CHECK(captures_of(HandPopulation{{{.species = prey}, {.species = prey}}}).empty());
  CHECK(captures_of(HandPopulation{{{.species = predator}, {.species = predator}}}).empty());
}

// Predators in bodies 0 and 1 stand around the prey in body 2; both orders are equally likely.
TEST_CASE("catch closest: two predators around one prey -> each catches it half of the time") {
  const HandPopulation robots{
      {{.species = predator, .x_m = 0.1}, {.species = predator, .x_m = 0.9}, {.species = prey, .x_m = 0.0}}};
  std::vector<std::size_t> by(2, 0);
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    const Captures result = captures_of(robots, seed);
    REQUIRE(result.size() == 1);
    ++by.at(result[0].hunter);
  }
  CHECK(chi_square(by) < 15.1);  // 1 degree of freedom: p = 1e-4
}

// Prey in body 0 beside the predator in body 1; predators in bodies 2 and 3, prey in body 4 beside 3. After the prey in body 0 is
// caught the list of predators is 0, 1, 2, 3: index 0 is now its offspring, index 1 the predator that caught it, index 2 body 2.
// The six orders of (index 0 = body 1, index 1 = body 2, index 2 = body 3) give:
//   0 first: body 1 catches 0, then indices 1 and 2 are bodies 1 (nobody left in reach) and 2: body 3 does not act.
//   2 before 0: body 3 catches 4, whose offspring stands after it in the list; then 0 catches.
TEST_CASE("catch closest: list grows with each catch -> some predators act twice, some never") {
  const HandPopulation robots{{{.species = prey, .x_m = 0.0},
                               {.species = predator, .x_m = 0.5},
                               {.species = predator, .x_m = 20.0},
                               {.species = predator, .x_m = 40.0},
                               {.species = prey, .x_m = 40.5}}};
  std::map<std::vector<std::pair<BodyIndex, BodyIndex>>, std::size_t> seen;
  constexpr std::size_t size = 12'000;
  for (std::uint64_t seed = 0; seed < size; ++seed) {
    std::vector<std::pair<BodyIndex, BodyIndex>> pairs;
    for (const auto& [hunter_body, victim] : captures_of(robots, seed)) pairs.emplace_back(hunter_body, victim);
    ++seen[pairs];
  }
  // orders 012, 021, 102 (0 before 2): only (1, 0); orders 120, 201, 210 (2 before 0): (3, 4) then (1, 0)
  REQUIRE(seen.size() == 2);
  const std::vector<std::size_t> counts{seen[{{1, 0}}], seen[{{3, 4}, {1, 0}}]};
  CHECK(chi_square(counts) < 15.1);
}

// Prey in bodies 0 and 1 beside the predator in body 2, another predator far away in body 3: if index 0 (body 2) comes first, the
// list becomes 0, 2, 3 and index 1 is body 2 again, which catches a second time.
TEST_CASE("catch closest: offspring earlier in the list -> predator acts twice") {
  const HandPopulation robots{{{.species = prey, .x_m = 0.2},
                               {.species = prey, .x_m = 0.4},
                               {.species = predator, .x_m = 0.0},
                               {.species = predator, .x_m = 20.0}}};
  std::vector<std::size_t> catches(3, 0);
  for (std::uint64_t seed = 0; seed < 10'000; ++seed) {
    const Captures result = captures_of(robots, seed);
    if (result.size() == 2) CHECK(result == Captures{{2, 0}, {2, 1}});
    ++catches.at(result.size());
  }
  CHECK(catches[0] == 0);
  CHECK(catches[1] == doctest::Approx(5000).epsilon(4.0 / 100.0));
  CHECK(catches[2] == doctest::Approx(5000).epsilon(4.0 / 100.0));
}

TEST_CASE("catch closest: offspring of this tick -> no catch") {
  // index 0 catches body 0; index 1 is the catcher again or, had the offspring hunted, body 1 would fall to body 0
  const HandPopulation robots{{{.species = prey, .x_m = 0.0},
                               {.species = prey, .x_m = -0.9},
                               {.species = predator, .x_m = 0.9},
                               {.species = predator, .x_m = 20.0}}};
  for (std::uint64_t seed = 0; seed < 100; ++seed) CHECK(captures_of(robots, seed) == Captures{{2, 0}});
}

TEST_CASE("catch closest: caught hunter of a middle species -> no further catch") {
  const HandPopulation robots{{{.species = hunter}, {.species = grazer, .x_m = 0.5}, {.species = plant, .x_m = 1.0}},
                              chain_web()};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Captures result = captures_of(robots, seed);
    const bool hunter_first = result == Captures{{0, 1}};
    const bool grazer_first = result == Captures{{1, 2}} || result == Captures{{1, 2}, {0, 1}};
    CHECK((hunter_first || grazer_first));
  }
}

TEST_CASE("catch closest: n predators -> n - 1 draws") {
  HandPopulation robots{{{.species = predator}, {.species = predator, .x_m = 9.0}, {.species = predator, .x_m = 5.0}}};
  Rng rng{1, Stream::captures};
  Rng reference = rng;
  CHECK(CatchClosest{}.captures(robots.at_tick(100).view(), rng).empty());
  reference.bits();
  reference.bits();
  CHECK(rng.bits() == reference.bits());
}

TEST_CASE("catch closest: random populations -> each victim once, in reach, active, edible and closest") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 20, predator_prey_web(), 2.0);
    const View view = robots.view();
    Rng rng{seed, Stream::captures};
    std::set<BodyIndex> victims;
    for (const auto& [hunter_body, victim] : CatchClosest{}.captures(view, rng)) {
      RC_ASSERT(view.web.eats(view.robots[hunter_body].species, view.robots[victim].species));
      RC_ASSERT(view.robots[victim].active);
      RC_ASSERT(view.age_s(view.robots[hunter_body]) >= 20.0);
      RC_ASSERT(view.distance_m(hunter_body, victim) <= 1.0);
      for (BodyIndex other = 0; other < 20; ++other) {
        if (view.robots[other].species != prey || !view.robots[other].active || victims.contains(other)) continue;
        RC_ASSERT(view.distance_m(hunter_body, other) >= view.distance_m(hunter_body, victim));
      }
      RC_ASSERT(victims.insert(victim).second);
    }
  }));
}
