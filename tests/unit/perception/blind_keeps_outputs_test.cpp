// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/perception/blind_rule/blind_keeps_outputs.hpp>

TEST_CASE("blind keeps outputs: the brain is not asked, whatever the tag ratio") {
  const trophic::perception::blind_rule::BlindKeepsOutputs rule;
  CHECK_FALSE(rule.inputs(0.5));
  CHECK_FALSE(rule.inputs(0.0));
  CHECK_FALSE(rule.inputs(-0.5));
}
