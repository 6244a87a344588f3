// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/perception/visibility/same_tag.hpp>

using namespace trophic;

TEST_CASE("same tag: perceives active individuals of the own tag, whatever its own activity") {
  const perception::visibility::SameTag rule;
  const auto one = [](int tag, bool active) {
    Individual individual;
    individual.tag = tag;
    individual.active = active;
    return individual;
  };
  for (const bool own_active : {true, false}) {
    for (const int own : {-1, 1}) {
      CHECK(rule.perceives(one(own, own_active), one(own, true)));
      CHECK_FALSE(rule.perceives(one(own, own_active), one(-own, true)));
      CHECK_FALSE(rule.perceives(one(own, own_active), one(own, false)));
      CHECK_FALSE(rule.perceives(one(own, own_active), one(-own, false)));
    }
  }
}
