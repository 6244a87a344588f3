// SPDX-License-Identifier: MIT
// Checks that a brain's decision can affect the joints of a robot.
#pragma once

#include <cstddef>
#include <string_view>
#include <trophic/control/steering/contract.hpp>
#include <trophic/support/linkage.hpp>
#include <vector>

namespace trophic::locomotion {

/// The target angle of `check_steerable`, to the right and to the left; the paper's brain turns by it.
inline constexpr double probe_angle_rad = 0.7;

/// Throws std::invalid_argument: this robot cannot be steered by this rule.
[[noreturn]] void refuse_steering(const RobotModel& robot, std::string_view steering, const std::vector<Side>& sides);

/// Throws std::invalid_argument, naming robot, steering and hinges, if a right turn and a left turn give the same joint
/// targets: brains would have no effect on the motion of robots. Accepts a rule with `steers = false`.
template <control::Steering SteeringRule>
void check_steerable(const RobotModel& robot, const SteeringRule& steering) {
  if constexpr (requires { requires !SteeringRule::steers; }) return;
  const std::vector<Side> sides = sides_of(robot);
  std::vector<double> right_rad(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) right_rad[i] = i % 2 == 0 ? 0.5 : -0.25;
  std::vector<double> left_rad = right_rad;
  steering.steer(probe_angle_rad, sides, right_rad);
  steering.steer(-probe_angle_rad, sides, left_rad);
  if (right_rad != left_rad) return;
  refuse_steering(robot, SteeringRule::name, sides);
}

}  // namespace trophic::locomotion

#if TROPHIC_HEADER_ONLY
#include <trophic/control/locomotion/steerable.ipp>
#endif
