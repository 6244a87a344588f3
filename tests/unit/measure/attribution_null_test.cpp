// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/measure/attribution_null.hpp>
#include <unit/measure/catches.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using measure::EventRow;

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
