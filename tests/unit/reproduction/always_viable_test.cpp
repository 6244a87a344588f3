// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/reproduction/viability/always_viable.hpp>

using namespace trophic;

TEST_CASE("always viable: any body -> not refused, and tried once") {
  const reproduction::viability::AlwaysViable rule;
  CHECK_FALSE(rule.refusal({}, body::build({})));
  CHECK(rule.attempts() == 1);
}
