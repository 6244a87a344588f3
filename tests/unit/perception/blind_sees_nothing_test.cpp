// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/perception/blind_rule/blind_sees_nothing.hpp>

using trophic::perception::BrainInputs;

TEST_CASE("blind sees nothing: neither side, as far as can be, and the tag ratio as it is") {
  const trophic::perception::blind_rule::BlindSeesNothing rule;
  CHECK(rule.inputs(0.25) == BrainInputs{.angle = 0.0, .distance = 1.0, .tag_ratio = 0.25});
  CHECK(rule.inputs(-0.5) == BrainInputs{.angle = 0.0, .distance = 1.0, .tag_ratio = -0.5});
}
