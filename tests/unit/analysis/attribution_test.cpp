// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/metrics/attribution.hpp>
#include <unit/analysis/catches.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using analysis::EventRow;

TEST_CASE("attribution: catches -> shares of the inherited among the caught, the catches and the catchers") {
  const auto events = three_catches();
  CHECK(*analysis::attribution_caught(events, prey) == doctest::Approx(1.0 / 3.0));
  CHECK(*analysis::attribution_catches(events, predator) == doctest::Approx(2.0 / 3.0));
  CHECK(*analysis::attribution_catchers(events, predator) == doctest::Approx(1.0 / 2.0));
}

TEST_CASE("attribution: starved or sacrificed prey -> not counted as caught") {
  auto events = three_catches();
  events.push_back(death(8, 8, prey, 1, from_parent, Cause::sacrificed));
  events.push_back(death(8, 4, predator, 4, from_parent, Cause::starved));
  CHECK(*analysis::attribution_caught(events, prey) == doctest::Approx(1.0 / 3.0));
  CHECK_FALSE(analysis::attribution_caught(events, predator));
}

TEST_CASE("attribution: log without causes -> all dead prey count, credited to the occupant of the last killer's body") {
  auto events = three_catches();
  CHECK(*analysis::attribution_died(events, prey) == doctest::Approx(1.0 / 3.0));
  CHECK(*analysis::attribution_credited(events, prey_and_predators, predator) == doctest::Approx(2.0 / 3.0));
  // Body 0 becomes a prey again and is sacrificed. Body 4 once caught it; its present occupant is a random hunter.
  events.push_back(death(8, 5, predator, 0, from_parent, Cause::starved));
  events.push_back(birth(8, 8, prey, 0, from_parent));
  events.push_back(birth(8, 9, predator, 4, drawn));
  events.push_back(death(9, 8, prey, 0, from_parent, Cause::sacrificed));
  CHECK(*analysis::attribution_died(events, prey) == doctest::Approx(2.0 / 4.0));
  CHECK(*analysis::attribution_credited(events, prey_and_predators, predator) == doctest::Approx(2.0 / 4.0));
  CHECK(*analysis::attribution_catches(events, predator) == doctest::Approx(2.0 / 3.0));
}

TEST_CASE("attribution: log without causes, body that was never caught -> credited to body 1") {
  const std::vector<EventRow> events{birth(0, 0, prey, 0, drawn), birth(0, 1, predator, 1, from_parent),
                                     death(9, 0, prey, 0, drawn, Cause::sacrificed)};
  CHECK(*analysis::attribution_credited(events, prey_and_predators, predator) == 1.0);
  CHECK_FALSE(analysis::attribution_credited(events, prey_and_predators, prey));
}

TEST_CASE("attribution: no catch -> no value") {
  const std::vector<EventRow> quiet{birth(0, 0, prey, 0, drawn), birth(0, 1, predator, 1, drawn),
                                    death(9, 1, predator, 1, drawn, Cause::starved)};
  for (const auto& events : {std::vector<EventRow>{}, quiet}) {
    CHECK_FALSE(analysis::attribution_caught(events, prey));
    CHECK_FALSE(analysis::attribution_catches(events, predator));
    CHECK_FALSE(analysis::attribution_catchers(events, predator));
    CHECK_FALSE(analysis::attribution_died(events, prey));
    CHECK_FALSE(analysis::attribution_credited(events, prey_and_predators, predator));
  }
}

TEST_CASE("attribution: species that hunts and is hunted -> both attributions, separate from the others'") {
  constexpr Species grass = 0;
  constexpr Species sheep = 1;
  constexpr Species wolf = 2;
  const std::vector<EventRow> events{birth(0, 0, grass, 0, from_parent),
                                     birth(0, 1, sheep, 1, drawn),
                                     birth(0, 2, wolf, 2, from_parent),
                                     capture(2, 1, sheep, 1, drawn, 0),
                                     death(2, 0, grass, 0, from_parent, Cause::caught),
                                     capture(4, 2, wolf, 2, from_parent, 1),
                                     death(4, 1, sheep, 1, drawn, Cause::caught)};
  CHECK(*analysis::attribution_caught(events, grass) == 1.0);
  CHECK(*analysis::attribution_caught(events, sheep) == 0.0);
  CHECK(*analysis::attribution_catches(events, sheep) == 0.0);
  CHECK(*analysis::attribution_catches(events, wolf) == 1.0);
  CHECK_FALSE(analysis::attribution_catches(events, grass));
}
