// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/visibility/same_tag.hpp>

using namespace trophic;

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
