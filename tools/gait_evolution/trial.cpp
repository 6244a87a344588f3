// SPDX-License-Identifier: MIT
// Definitions of trial.hpp.
#include <tools/gait_evolution/trial.hpp>

#include <numbers>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/habitat/ground_pose.hpp>

namespace trophic::gait_evolution {

double Track::turn_rate_rad_s() const {
  const double middle = static_cast<double>(poses.size() - 1) / 2.0;
  double turned_rad = 0.0;  // the headings as one continuous curve
  double sum_kt = 0.0;
  double sum_kk = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) turned_rad += wrap_angle(poses[i].heading_rad - poses[i - 1].heading_rad);
    const double k = static_cast<double>(i) - middle;
    sum_kt += k * turned_rad;
    sum_kk += k * k;
  }
  return sum_kt / sum_kk * control_hz;
}

std::array<double, 2> Track::forward_and_left_m_s(double window_s) const {
  const auto window = static_cast<std::size_t>(std::llround(window_s * control_hz));
  double forward_m = 0.0;
  double left_m = 0.0;
  for (std::size_t first = 0; first + window < poses.size(); ++first) {
    double ahead_x = 0.0;
    double ahead_y = 0.0;
    for (std::size_t i = first; i <= first + window; ++i) {
      ahead_x += std::cos(poses[i].heading_rad);
      ahead_y += std::sin(poses[i].heading_rad);
    }
    const double norm = std::hypot(ahead_x, ahead_y);
    const double dx = poses[first + window].x_m - poses[first].x_m;
    const double dy = poses[first + window].y_m - poses[first].y_m;
    forward_m += (dx * ahead_x + dy * ahead_y) / norm;
    left_m += (dy * ahead_x - dx * ahead_y) / norm;
  }
  const double total_s = static_cast<double>((poses.size() - window) * window) / control_hz;
  return {forward_m / total_s, left_m / total_s};
}

Pilot steady(double target_angle_rad) {
  return [target_angle_rad](double, const GroundPose&) { return target_angle_rad; };
}

double bearing_of_minus_x_rad(const GroundPose& now) {
  return -wrap_angle(std::numbers::pi - now.heading_rad);
}

Arena endless_floor() {
  return {.name = "endless_floor", .half_side_m = 1000.0, .extent_m = 2000.0, .friction = 1.0, .height_field = {}};
}

Track try_out(const RobotModel& robot, const Gait& gait, const control::steering::TargetedSteering& steering, const Trial& trial,
              const Physics& physics, const BackendChoice& choice, const Pilot& pilot, double start_turn_rad) {
  const double facing_rad = trial.facing == Facing::forward_axis ? robot.forward_rad : 0.0;
  const double yaw_rad = std::numbers::pi - facing_rad + start_turn_rad;
  const Pose start{.position_m = {0.0, 0.0, robot.rest_height_m},
                   .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{yaw_rad, Eigen::Vector3d::UnitZ()}}};
  const std::unique_ptr<AnyBackend> backend = choice.build(robot, endless_floor(), std::span{&start, 1}, physics);
  locomotion::Locomotion locomotion{robot, gait, steering, 1, {trial.control_hz, trial.cpg_integration}};
  Track track{.control_hz = trial.control_hz, .poses = {ground_pose(backend->pose(0), robot.forward_rad)}};
  for (std::int64_t step = 0; step < trial.steps(); ++step) {
    if (step < trial.idle_steps) {
      locomotion.wait(*backend, 1);
    } else {
      const std::array target_angle_rad{pilot(locomotion.time_s(), track.poses.back())};
      locomotion.advance(*backend, 1, target_angle_rad);
    }
    track.poses.push_back(ground_pose(backend->pose(0), robot.forward_rad));
  }
  track.engine_share = backend->engine_share();
  return track;
}

MeasuredWalk measure_walk(RobotModel robot, const Gait& gait, const control::steering::TargetedSteering& steering,
                          const Trial& trial, const Physics& physics, const BackendChoice& backend, std::size_t starts) {
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
