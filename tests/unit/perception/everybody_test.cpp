// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/perception/visibility/everybody.hpp>

using namespace trophic;

TEST_CASE("everybody: perceives whoever is active, whatever the tags") {
  const perception::visibility::Everybody rule;
  Individual self;
  Individual other;
  for (const int tag : {-1, 1}) {
    other.tag = tag;
    other.active = true;
    CHECK(rule.perceives(self, other));
    other.active = false;
    CHECK_FALSE(rule.perceives(self, other));
  }
  self.active = false;
  other.active = true;
  CHECK(rule.perceives(self, other));
}
