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

/// Throws std::invalid_argument because this robot cannot be steered by this rule.
[[noreturn]] void refuse_steering(const RobotModel& robot, std::string_view steering, const std::vector<HingePlace>& hinges);

/// Throws std::invalid_argument, naming robot, steering and hinges, if a turn to one side gives the same joint targets as walking
/// straight or as the other turn: brains would have no effect on the motion of robots. Accepts a rule with `steers = false`.
template <control::Steering SteeringRule>
void check_steerable(const RobotModel& robot, const SteeringRule& steering) {
  if constexpr (requires { requires !SteeringRule::steers; }) return;
  const std::vector<HingePlace> hinges = hinge_places(robot);
  std::vector<double> straight_rad(hinges.size());
  for (std::size_t i = 0; i < hinges.size(); ++i) straight_rad[i] = i % 2 == 0 ? 0.5 : -0.25;
  const auto steered = [&](double target_angle_rad) {
    std::vector<double> targets_rad = straight_rad;
    steering.steer(target_angle_rad, hinges, targets_rad);
    return targets_rad;
  };
  const std::vector<double> ahead_rad = steered(0.0);
  const std::vector<double> right_rad = steered(probe_angle_rad);
  const std::vector<double> left_rad = steered(-probe_angle_rad);
  if (right_rad == left_rad || right_rad == ahead_rad || left_rad == ahead_rad)
    refuse_steering(robot, SteeringRule::name, hinges);
}

}  // namespace trophic::locomotion

#if TROPHIC_HEADER_ONLY
#include <trophic/control/locomotion/steerable.ipp>
#endif
