// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/perception/visibility/all_active.hpp>
#include <trophic/perception/visibility/same_tag.hpp>
#include <trophic/perception/visibility/same_tag_if_active.hpp>
#include <trophic/perception/visibility/within_range.hpp>

using namespace trophic;
using test::predator;
using test::prey;

TEST_CASE("all active: any tags -> perceives every active individual") {
  const perception::visibility::AllActive rule;
  Rng rng{1, Stream::visibility};
  const test::HandPopulation robots{{{.tag = 1}, {.tag = -1}, {.tag = 1, .active = false}, {.tag = -1, .active = false}}};
  for (BodyIndex self = 0; self < 4; ++self) {
    CHECK(rule.perceives(self, 0, robots.view(), rng));
    CHECK(rule.perceives(self, 1, robots.view(), rng));
    CHECK_FALSE(rule.perceives(self, 2, robots.view(), rng));
    CHECK_FALSE(rule.perceives(self, 3, robots.view(), rng));
  }
}

TEST_CASE("same tag if active: tags and activities -> perceives only if the tags are equal and both are active") {
  Rng rng{1, Stream::visibility};
  for (const int tag : {-1, 1, 7}) {
    for (const bool same : {true, false}) {
      for (const bool active : {true, false}) {
        for (const bool other_active : {true, false}) {
          const test::HandPopulation robots{{{.tag = tag, .active = active}, {.tag = same ? tag : -tag, .active = other_active}}};
          const perception::visibility::SameTagIfActive rule;
          CHECK(rule.perceives(0, 1, robots.view(), rng) == (same && active && other_active));
        }
      }
    }
  }
}

TEST_CASE("same tag: own activity -> irrelevant, perceives active individuals with its tag") {
  const perception::visibility::SameTag rule;
  Rng rng{1, Stream::visibility};
  for (const bool own_active : {true, false}) {
    for (const int own : {-1, 1, 7}) {
      const test::HandPopulation robots{{{.tag = own, .active = own_active},
                                         {.tag = own, .active = true},
                                         {.tag = -own, .active = true},
                                         {.tag = own, .active = false},
                                         {.tag = -own, .active = false}}};
      CHECK(rule.perceives(0, 1, robots.view(), rng));
      for (BodyIndex other = 2; other < 5; ++other) CHECK_FALSE(rule.perceives(0, other, robots.view(), rng));
    }
  }
}

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
