// SPDX-License-Identifier: MIT
// What a brain was told, what it answered and what became of that, as observers are told.
#pragma once

#include <span>
#include <trophic/population/individual.hpp>

namespace trophic::observe {

/// One question to one brain, after it was acted upon. Spans are valid during the call.
struct DecisionRecord {
  BodyIndex body = 0;
  std::span<const double> inputs;   ///< the values of all sensors, in the order of RunDescription::inputs
  std::span<const double> outputs;  ///< the output neurons: target angle, tag; empty for a brain that does not show them
  double target_angle_rad = 0.0;    ///< what it decided
  int tag = 0;                      ///< that it wanted to show
  int tag_before = 0;               ///< that the robot showed
  bool might_switch = false;        ///< whether the rules let the tag change at this tick
};

}  // namespace trophic::observe
