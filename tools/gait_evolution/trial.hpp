// SPDX-License-Identifier: MIT
// One gait tried out by one robot alone on an endless floor, and the measures of its path.
#pragma once

#include <cmath>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/support/units.hpp>

namespace trophic::gait_evolution {

/// The ground poses of one robot, at the start and after every control step.
struct Track {
  double control_hz = 60.0;
  std::vector<GroundPose> poses;  ///< at least one
  double engine_share = 0.0;      ///< of the steps, those that the engine took although the backend has a faster way

  /// How far the robot got towards the negative x-axis, m.
  [[nodiscard]] double displacement_minus_x_m() const { return poses.front().x_m - poses.back().x_m; }

  /// Distance between start and end, m.
  [[nodiscard]] double displacement_m() const { return distance_m(poses.front(), poses.back()); }

  /// Slope of the straight line that fits the heading best (least squares): legs make a body swing, ends alone would mislead.
  /// Counter-clockwise positive. At least two poses.
  [[nodiscard]] double turn_rate_rad_s() const;

  /// Mean speed along the heading (first) and to its left (second): path in each window of that length, seen along the mean
  /// heading in it. The track is longer than a window.
  [[nodiscard]] std::array<double, 2> forward_and_left_m_s(double window_s = 5.0) const;
};

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
    return std::tuple{
        field("duration_s", &Trial::duration_s, above_to(0.0, 1e5), "simulated time of one evaluation"),
        field("control_hz", &Trial::control_hz, between(1.0, 1e5), "control steps of the gait per simulated second"),
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
[[nodiscard]] Track try_out(const RobotModel& robot, const Gait& gait, const control::steering::TargetedSteering& steering,
                            const Trial& trial, const Physics& physics, const BackendChoice& choice, const Pilot& pilot,
                            double start_turn_rad = 0.0);

/// Mean speed along the heading and turning rate of a robot that is steered by +-0.7 rad, the cognitive brain's two outputs: the
/// two numbers that engines without joints need.
/// Rule: the rate is half of what turns the robot to one side rather than the other, per rad; a drift that both share cancels.
/// Contacts make walking chaotic: means of `starts` trials to each side, which begin up to 1 mm above the floor. Throws Diverged.
[[nodiscard]] MeasuredWalk measure_walk(RobotModel robot, const Gait& gait, const control::steering::TargetedSteering& steering,
                                        const Trial& trial, const Physics& physics, const BackendChoice& backend,
                                        std::size_t starts);

}  // namespace trophic::gait_evolution
