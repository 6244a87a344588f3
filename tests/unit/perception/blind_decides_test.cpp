// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/perception/blind_rule/blind_decides.hpp>

TEST_CASE("blind decides: the brain is asked all the same") {
  CHECK(trophic::perception::blind_rule::BlindDecides{}.decides());
}
