// SPDX-License-Identifier: MIT
// A brain's inputs, outputs and decision, as observers get them.
#pragma once

#include <span>
#include <trophic/population/individual.hpp>

namespace trophic::observe {

/// One decision of one brain, after it was applied. Spans are valid during the call.
struct DecisionRecord {
  BodyIndex body = 0;
  std::span<const double> inputs;  ///< the values of all sensors, in the order of RunDescription::inputs
  std::span<const double>
      outputs;                    ///< the output neurons, in the order of RunDescription::outputs; empty for a brain without them
  double target_angle_rad = 0.0;  ///< the decision
  int tag = 0;                    ///< the tag that it chose
  int tag_before = 0;             ///< the tag that the robot showed before
  bool might_switch = false;      ///< whether the rules allow a tag switch at this tick
};

}  // namespace trophic::observe
