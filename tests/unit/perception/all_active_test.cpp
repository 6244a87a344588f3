// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/visibility/all_active.hpp>

using namespace trophic;

TEST_CASE("all_active: perceives whoever is active, whatever the tags") {
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
