// SPDX-License-Identifier: MIT
// How a robot walks with a gait, in the two numbers that engines without joints need.
#pragma once

#include <tools/gait_evolution/trial.hpp>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/habitat/gait.hpp>

namespace trophic::gait_evolution {

/// Mean speed along the heading and turning rate of a robot that is steered by +-0.7 rad, the cognitive brain's two outputs.
/// Rule: the rate is half of what turns the robot to one side rather than the other, per rad; a drift that both share cancels.
/// Contacts make walking chaotic: means of `starts` trials to each side, which begin up to 1 mm above the floor. Throws Diverged.
template <control::Steering SteeringRule>
[[nodiscard]] MeasuredWalk measure_walk(RobotModel robot, const Gait& gait, const SteeringRule& steering, const Trial& trial,
                                        const Physics& physics, const BackendChoice& backend, std::size_t starts) {
  constexpr double target_angle_rad = 0.7;
  const double rest_height_m = robot.rest_height_m;
  const auto trials = static_cast<double>(2 * starts);
  MeasuredWalk walk;
  for (std::size_t start = 0; start < starts; ++start) {
    robot.rest_height_m = rest_height_m + 0.001 * static_cast<double>(start) / static_cast<double>(starts);
    for (const double side : {1.0, -1.0}) {
      const Track track = try_out(robot, gait, steering, trial, physics, backend, steady(side * target_angle_rad));
      walk.speed_m_s += track.forward_and_left_m_s()[0] / trials;
      walk.turn_rate_per_rad -= side * track.turn_rate_rad_s() / (trials * target_angle_rad);
    }
  }
  return walk;
}

}  // namespace trophic::gait_evolution
