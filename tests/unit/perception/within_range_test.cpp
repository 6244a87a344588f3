// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/perception/visibility/within_range.hpp>

using namespace trophic;
using test::predator;
using test::prey;

TEST_CASE("within range: own tag at exactly the range -> perceived, beyond, inactive or other tag -> not") {
  const perception::visibility::WithinRange rule{{.range_m = 5.0}};
  Rng rng{1, Stream::visibility};
  const test::HandPopulation robots{
      {{}, {.x_m = 3.0, .y_m = 4.0}, {.x_m = 3.0, .y_m = 4.000001}, {.x_m = 1.0, .tag = -1}, {.x_m = 1.0, .active = false}}};
  CHECK(rule.perceives(0, 1, robots.view(), rng));
  CHECK(rule.perceives(1, 0, robots.view(), rng));
  for (BodyIndex other = 2; other < 5; ++other) CHECK_FALSE(rule.perceives(0, other, robots.view(), rng));
}

TEST_CASE("within range: adversary -> closest in range, or none") {
  const perception::visibility::WithinRange rule{{.range_m = 3.0}};
  test::HandPopulation robots{
      {{.species = prey}, {.species = predator, .x_m = 2.0}, {.species = predator, .x_m = 1.0, .tag = -1}}};
  const auto seen = [&] {
    return perception::adversary(0, robots.view(), [&](BodyIndex self, BodyIndex other) {
      Rng rng{1, Stream::visibility};
      return rule.perceives(self, other, robots.view(), rng);
    });
  };
  REQUIRE(seen());
  CHECK(seen()->adversary == 1);
  robots.poses[1].x_m = 3.5;
  CHECK_FALSE(seen());
}
