// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/reproduction/viability/within_mass.hpp>

using namespace trophic;
using reproduction::viability::WithinMass;

TEST_CASE("within mass: a core of 0.25 kg -> refused below its mass, by a sentence") {
  const RobotModel core = body::build({});
  CHECK_FALSE(WithinMass{{.most_kg = 0.25}}.refusal({}, core));
  CHECK(WithinMass{{.most_kg = 0.125}}.refusal({}, core) == "0.25 kg: must be <= 0.125");
  CHECK(WithinMass{{.attempts = 7}}.attempts() == 7);
}
