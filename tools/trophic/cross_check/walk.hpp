// SPDX-License-Identifier: MIT
// One gait in one engine: how fast robots walk and turn, and what it costs their servos.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tools/gait_evolution/trial.hpp>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/locomotion/cpg.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/habitat/habitat.hpp>

namespace trophic::command::cross_check {

/// An engine with its settings, walking at one timestep towards one target angle.
struct Condition {
  std::string engine;
  std::string settings;
  double timestep_s = 0.0012;
  double target_angle_rad = 0.0;
};

/// Measures of one walking robot. Speed: path between samples 2 s apart, over time. Power: sum over hinges of |torque x
/// velocity|, mean over time. Torque: mean over hinges and time of |torque|, by the servo's own formula.
struct Walk {
  double speed_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
  double power_W = 0.0;
  double torque_N_m = 0.0;
  std::vector<GroundPose> path;  ///< every 2 s, the start included
};

inline constexpr double sample_s = 2.0;
inline constexpr std::string_view default_settings = "default";

/// Twelve robots out of each other's reach, each turned by 30 degrees more than the last: a gait meets the axes along which
/// engines cut the friction cone at every angle.
[[nodiscard]] inline std::vector<Pose> twelve_starts(const RobotModel& robot) {
  constexpr double apart_m = 40.0;
  std::vector<Pose> starts;
  for (int i = 0; i < 12; ++i) {
    const Eigen::AngleAxisd yaw{std::numbers::pi / 6.0 * i, Eigen::Vector3d::UnitZ()};
    starts.push_back(
        {.position_m = {apart_m * (i % 4), apart_m * (i / 4), robot.rest_height_m}, .orientation = Eigen::Quaterniond{yaw}});
  }
  return starts;
}

/// Walks for `duration_s` on an endless floor with the gait at 60 Hz, as an ecology does. Throws Diverged. No random draws.
[[nodiscard]] inline std::vector<Walk> walk(const Habitat& habitat, const Condition& condition, double duration_s,
                                            const BackendChoice& choice) {
  constexpr double control_hz = 60.0;
  constexpr int controls_per_sample = static_cast<int>(sample_s * control_hz);
  const RobotModel& robot = habitat.robot;
  const std::size_t hinges = robot.hinges.size();
  const auto hinges_at = hinge_places(robot);
  const control::steering::TargetedSteering steering{};
  const locomotion::Cpg cpg{habitat.gait};
  const std::vector<Pose> starts = twelve_starts(robot);
  const std::unique_ptr<AnyBackend> built =
      choice.build(robot, gait_evolution::endless_floor(), starts, {.timestep_s = condition.timestep_s});
  AnyBackend& backend = *built;
  Eigen::MatrixXd states = cpg.initial_states();
  std::vector<double> targets_rad(hinges);
  std::vector<double> before_rad(starts.size() * hinges, 0.0);
  std::vector<Walk> walks(starts.size());
  const auto sample = [&] {
    for (std::size_t i = 0; i < walks.size(); ++i) {
      walks[i].path.push_back(ground_pose(backend.pose(i), robot.forward_rad));
    }
  };
  const auto look_at_servos = [&] {
    for (std::size_t i = 0; i < walks.size(); ++i) {
      const std::span<const double> angles_rad = backend.joint_angles(i);
      for (std::size_t hinge = 0; hinge < hinges; ++hinge) {
        const Servo& servo = robot.hinges[hinge].servo;
        double& before = before_rad[i * hinges + hinge];
        const double velocity_rad_s = (angles_rad[hinge] - before) / condition.timestep_s;
        const double target_rad = std::clamp(targets_rad[hinge], -servo.target_limit_rad, servo.target_limit_rad);
        const double torque_N_m = servo.position_gain * (target_rad - angles_rad[hinge]) - servo.velocity_gain * velocity_rad_s;
        walks[i].power_W += std::abs(torque_N_m * velocity_rad_s);
        walks[i].torque_N_m += std::abs(torque_N_m) / static_cast<double>(hinges);
        before = angles_rad[hinge];
      }
    }
  };

  sample();
  std::size_t steps = 0;
  const int controls = static_cast<int>(std::round(duration_s * control_hz));
  for (int control = 1; control <= controls; ++control) {
    cpg.step(states);
    cpg.outputs(states, 0, targets_rad);
    steering.steer(condition.target_angle_rad, hinges_at, targets_rad);
    for (std::size_t i = 0; i < walks.size(); ++i) backend.set_joint_targets(i, targets_rad);
    while (backend.time_s() < control / control_hz - 1e-9) {
      backend.advance_to(backend.time_s() + condition.timestep_s);
      look_at_servos();
      ++steps;
    }
    if (control % controls_per_sample == 0) sample();
  }
  for (Walk& walk : walks) {
    for (std::size_t i = 1; i < walk.path.size(); ++i) {
      walk.speed_m_s += distance_m(walk.path[i - 1], walk.path[i]) / duration_s;
      walk.turn_rate_rad_s += wrap_angle(walk.path[i].heading_rad - walk.path[i - 1].heading_rad) / duration_s;
    }
    walk.power_W /= static_cast<double>(steps);
    walk.torque_N_m /= static_cast<double>(steps);
  }
  return walks;
}

}  // namespace trophic::command::cross_check
