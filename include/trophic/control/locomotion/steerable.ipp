// SPDX-License-Identifier: MIT
// Definitions of steerable.hpp.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <trophic/control/locomotion/steerable.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic::locomotion {

TROPHIC_INLINE void refuse_steering(const RobotModel& robot, std::string_view steering, const std::vector<HingePlace>& places) {
  std::string hinges;
  for (const Side side : {Side::left, Side::right, Side::middle}) {
    hinges += (hinges.empty() ? "" : ", ") + std::to_string(std::ranges::count(places, side, &HingePlace::side)) + " " +
              std::string{enum_name(side)};
  }
  throw std::invalid_argument{
      "ecology.robot = " + robot.name + " with rules.steering = " + std::string{steering} +
      ": cannot be steered to both sides: a turn moves no hinge, or it moves the same hinges as the opposite turn (" + hinges +
      "); bending_steering needs no hinges at the sides"};
}

}  // namespace trophic::locomotion
