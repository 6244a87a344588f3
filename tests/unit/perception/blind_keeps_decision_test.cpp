// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/perception/blind_rule/blind_keeps_decision.hpp>

TEST_CASE("blind keeps decision: the brain is not asked") {
  CHECK_FALSE(trophic::perception::blind_rule::BlindKeepsDecision{}.decides());
}
