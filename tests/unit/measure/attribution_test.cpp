// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/measure/attribution.hpp>
#include <trophic/measure/attribution_null.hpp>
#include <unit/measure/rows.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::test;
using measure::EventRow;

constexpr Origin from_parent = Origin::inherited;
constexpr Origin drawn = Origin::random;

/// Prey 0 (random), 1 (random), 2 (inherited), hunters 3 (random), 4 (inherited). Hunter 4 catches 0 and 2, hunter 3 catches 1;
/// the caught bodies go to 5, 6, 7, all predators.
std::vector<EventRow> three_catches() {
  return {birth(0, 0, prey, 0, drawn),
          birth(0, 1, prey, 1, drawn),
          birth(0, 2, prey, 2, from_parent),
          birth(0, 3, predator, 3, drawn),
          birth(0, 4, predator, 4, from_parent),
          capture(2, 4, predator, 4, from_parent, 0),
          death(2, 0, prey, 0, drawn, Cause::caught),
          birth(2, 5, predator, 0, from_parent),
          capture(4, 4, predator, 4, from_parent, 2),
          death(4, 2, prey, 2, from_parent, Cause::caught),
          birth(4, 6, predator, 2, from_parent),
          capture(6, 3, predator, 3, drawn, 1),
          death(6, 1, prey, 1, drawn, Cause::caught),
          birth(6, 7, predator, 1, drawn)};
}

}  // namespace

TEST_CASE("attribution counts the inherited among the caught, among catches and among catchers") {
  const auto events = three_catches();
  CHECK(*measure::attribution_caught(events, prey) == doctest::Approx(1.0 / 3.0));
  CHECK(*measure::attribution_catches(events, predator) == doctest::Approx(2.0 / 3.0));
  CHECK(*measure::attribution_catchers(events, predator) == doctest::Approx(1.0 / 2.0));
}

TEST_CASE("who starves or is sacrificed was not caught") {
  auto events = three_catches();
  events.push_back(death(8, 8, prey, 1, from_parent, Cause::sacrificed));
  events.push_back(death(8, 4, predator, 4, from_parent, Cause::starved));
  CHECK(*measure::attribution_caught(events, prey) == doctest::Approx(1.0 / 3.0));
  CHECK_FALSE(measure::attribution_caught(events, predator));
}

TEST_CASE("without a catch there is no attribution, and no null of it") {
  const std::vector<EventRow> quiet{birth(0, 0, prey, 0, drawn), birth(0, 1, predator, 1, drawn),
                                    death(9, 1, predator, 1, drawn, Cause::starved)};
  for (const auto& events : {std::vector<EventRow>{}, quiet}) {
    CHECK_FALSE(measure::attribution_caught(events, prey));
    CHECK_FALSE(measure::attribution_catches(events, predator));
    CHECK_FALSE(measure::attribution_catchers(events, predator));
    const auto null = measure::attribution_null(events, prey);
    CHECK_FALSE(null.caught);
    CHECK_FALSE(null.catches);
    CHECK_FALSE(null.catchers);
  }
}

TEST_CASE("the null is the share of inherited alive at each catch") {
  const auto events = three_catches();
  // Prey alive at the catches: 1 of 3 inherited, 1 of 2, 0 of 1.
  CHECK(*measure::attribution_null(events, prey).caught == doctest::Approx((1.0 / 3.0 + 1.0 / 2.0 + 0.0) / 3.0));
  // Hunters alive: 4 of {3, 4}; 4, 5 of {3, 4, 5}; 4, 5, 6 of {3, 4, 5, 6}.
  const auto null = measure::attribution_null(events, predator);
  CHECK(*null.catches == doctest::Approx((1.0 / 2.0 + 2.0 / 3.0 + 3.0 / 4.0) / 3.0));
  // Chance that a hunter has at least one of the catches made while it lived.
  const double founders = 1.0 - (1.0 / 2.0) * (2.0 / 3.0) * (3.0 / 4.0);
  const double fifth = 1.0 - (2.0 / 3.0) * (3.0 / 4.0);
  const double sixth = 1.0 - 3.0 / 4.0;
  CHECK(*null.catchers == doctest::Approx((founders + fifth + sixth) / (2.0 * founders + fifth + sixth)));
}

TEST_CASE("the inactive cannot be the random victim") {
  const std::vector<EventRow> events{birth(0, 0, prey, 0, drawn),
                                     birth(0, 1, prey, 1, from_parent, false),
                                     birth(0, 2, prey, 2, from_parent, false),
                                     birth(0, 3, predator, 3, drawn),
                                     activation(2, 2, prey, 2, from_parent),
                                     capture(2, 3, predator, 3, drawn, 0),
                                     death(2, 0, prey, 0, drawn, Cause::caught)};
  CHECK(*measure::attribution_null(events, prey).caught == doctest::Approx(0.5));
}

TEST_CASE("a species that hunts and is hunted has both attributions, apart from the others'") {
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
  CHECK(*measure::attribution_caught(events, grass) == 1.0);
  CHECK(*measure::attribution_caught(events, sheep) == 0.0);
  CHECK(*measure::attribution_catches(events, sheep) == 0.0);
  CHECK(*measure::attribution_catches(events, wolf) == 1.0);
  CHECK_FALSE(measure::attribution_catches(events, grass));
  CHECK(*measure::attribution_null(events, sheep).caught == 0.0);
}
