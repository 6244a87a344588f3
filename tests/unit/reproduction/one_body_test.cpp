// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/reproduction/body_plan/one_body.hpp>

using namespace trophic;

TEST_CASE("one body: any species -> the habitat's design") {
  Habitat habitat{.robot = {}, .arena = {}, .gait = {}};
  habitat.design.emplace().friction = 0.25;
  for (const Species species : {0U, 1U}) CHECK(reproduction::body_plan::OneBody{}.grow({}, species, habitat).friction == 0.25);
}
