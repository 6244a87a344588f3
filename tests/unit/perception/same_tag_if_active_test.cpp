// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/visibility/same_tag_if_active.hpp>

using namespace trophic;

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
