// SPDX-License-Identifier: MIT
// One candidate gait tried out: one robot alone on an endless floor.
#pragma once

#include <cmath>
#include <numbers>
#include <tools/gait_evolution/track.hpp>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/locomotion/cpg.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/ground_pose.hpp>

namespace trophic::gait_evolution {

/// Axis of the robot that points along the negative x-axis when a trial starts.
enum class Facing {
  forward_axis,  ///< so that displacement along -x is walking forward, as perception and steering understand it
  core_x         ///< the core's own x-axis
};
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Facing) {
  return {"forward_axis", "core_x"};
}

/// How a candidate is tried out (Sec. "Targeted Steering": 50 s; the paper is silent about the rest).
struct Trial {
  double duration_s = 50.0;
  double control_hz = 60.0;
  std::int64_t idle_steps = 0;  ///< the released code asks for control only after the first period
  Facing facing = Facing::forward_axis;
  CpgIntegration cpg_integration = CpgIntegration::exact;

  static constexpr auto fields() {
    return std::tuple{field("duration_s", &Trial::duration_s, above_to(0.0, 1e5), "simulated time of one evaluation"),
                      field("control_hz", &Trial::control_hz, between(1.0, 1e5), "gait control per simulated second"),
                      field("idle_steps", &Trial::idle_steps, between(0, 1e6), "control periods before the gait begins"),
                      field("facing", &Trial::facing, "what points along -x at the start: forward_axis or core_x"),
                      field("cpg_integration", &Trial::cpg_integration, "exact or rk4")};
  }

  [[nodiscard]] std::int64_t steps() const { return std::llround(duration_s * control_hz); }
};

/// The target angle for the next control step, from the time since the start and the pose now. May remember: used for one try.
using Pilot = std::function<double(double time_s, const GroundPose& now)>;

/// The same target angle all the time.
[[nodiscard]] Pilot steady(double target_angle_rad);

/// The direction of the negative x-axis relative to the heading; positive to the right, in [-pi, pi).
[[nodiscard]] double bearing_of_minus_x_rad(const GroundPose& now);

/// The floor of a trial: a plane whose walls are out of reach.
[[nodiscard]] Arena endless_floor();

/// Tries a gait: the robot starts at the origin, at rest, turned by `start_turn_rad` (counter-clockwise) from the trial's facing.
/// Locomotion as in the ecology; the pilot is asked before every control step. Throws Diverged. No random draws.
template <control::Steering SteeringRule>
[[nodiscard]] Track try_out(const RobotModel& robot, const Gait& gait, const SteeringRule& steering, const Trial& trial,
                            const Physics& physics, const BackendChoice& choice, const Pilot& pilot,
                            double start_turn_rad = 0.0) {
  const double facing_rad = trial.facing == Facing::forward_axis ? robot.forward_rad : 0.0;
  const double yaw_rad = std::numbers::pi - facing_rad + start_turn_rad;
  const Pose start{.position_m = {0.0, 0.0, robot.rest_height_m},
                   .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{yaw_rad, Eigen::Vector3d::UnitZ()}}};
  const std::unique_ptr<AnyBackend> built = choice.build(robot, endless_floor(), std::span{&start, 1}, physics);
  AnyBackend& backend = *built;
  locomotion::Locomotion<SteeringRule> locomotion{robot, gait, steering, 1, {trial.control_hz, trial.cpg_integration}};
  Track track{.control_hz = trial.control_hz, .poses = {ground_pose(backend.pose(0), robot.forward_rad)}};
  for (std::int64_t step = 0; step < trial.steps(); ++step) {
    if (step < trial.idle_steps) {
      locomotion.wait(backend, 1);
    } else {
      const std::array target_angle_rad{pilot(locomotion.time_s(), track.poses.back())};
      locomotion.advance(backend, 1, target_angle_rad);
    }
    track.poses.push_back(ground_pose(backend.pose(0), robot.forward_rad));
  }
  track.engine_share = backend.engine_share();
  return track;
}

}  // namespace trophic::gait_evolution
