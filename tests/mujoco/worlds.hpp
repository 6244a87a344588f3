// SPDX-License-Identifier: MIT
// Worlds of spiders with a gait each, for tests and benchmarks of engines.
#pragma once

#include <algorithm>
#include <trophic/backend/mujoco.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

namespace trophic::test {

constexpr double control_period_s = 1.0 / 60.0;

inline const RobotModel spider = load_robot("spider");
inline const Arena square = load_arena("walled_square");

/// Sine targets with frequency, phases and amplitudes of the robot's own, so that no two robots move alike.
inline std::vector<double> own_gait(std::size_t robot, std::size_t hinges, double time_s) {
  Rng rng{7, Stream::user, robot};
  const double frequency_hz = rng.uniform(0.4, 1.2);
  std::vector<double> targets_rad(hinges);
  for (double& target_rad : targets_rad) {
    const double amplitude_rad = rng.uniform(0.3, 0.9);
    const double phase_rad = rng.uniform(0.0, 2.0 * std::numbers::pi);
    target_rad = amplitude_rad * std::sin(2.0 * std::numbers::pi * frequency_hz * time_s + phase_rad);
  }
  return targets_rad;
}

inline Pose standing(const RobotModel& robot, double x_m, double y_m, double yaw_rad) {
  return {{x_m, y_m, robot.rest_height_m + 0.001}, Eigen::Quaterniond{Eigen::AngleAxisd{yaw_rad, Eigen::Vector3d::UnitZ()}}};
}

/// `robots` on a square lattice with `spacing_m`, each moved at random by up to a tenth of it and turned at random.
inline std::vector<Pose> lattice(const RobotModel& robot, std::size_t robots, double spacing_m) {
  std::vector<Pose> poses;
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(robots))));
  const double middle = 0.5 * static_cast<double>(side - 1);
  for (std::size_t i = 0; i < robots; ++i) {
    Rng rng{11, Stream::placement, i};
    const double x_m = spacing_m * (static_cast<double>(i % side) - middle + rng.uniform(-0.1, 0.1));
    const double y_m = spacing_m * (static_cast<double>(i / side) - middle + rng.uniform(-0.1, 0.1));
    poses.push_back(standing(robot, x_m, y_m, rng.uniform(-std::numbers::pi, std::numbers::pi)));
  }
  return poses;
}

/// `robots` anywhere in a square of the given side, which may overlap.
inline std::vector<Pose> crowd(const RobotModel& robot, std::size_t robots, double side_m, std::uint64_t seed) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < robots; ++i) {
    Rng rng{seed, Stream::placement, i};
    const double x_m = rng.uniform(-0.5, 0.5) * side_m;
    const double y_m = rng.uniform(-0.5, 0.5) * side_m;
    poses.push_back(standing(robot, x_m, y_m, rng.uniform(-std::numbers::pi, std::numbers::pi)));
  }
  return poses;
}

/// The same without any two robots nearer than 0.42 m, so that no robot starts inside another.
inline std::vector<Pose> tight_crowd(const RobotModel& robot, std::size_t robots, double side_m, std::uint64_t seed) {
  std::vector<Pose> poses;
  for (; poses.size() < robots; ++seed) {
    const Pose pose = crowd(robot, 1, side_m, seed).front();
    const auto apart = [&](const Pose& other) { return (pose.position_m - other.position_m).norm() > 0.42; };
    if (std::ranges::all_of(poses, apart)) poses.push_back(pose);
  }
  return poses;
}

/// Advances tick by tick, each robot under its own gait. The gait is a function of time alone.
template <JointDriven B>
void walk(B& backend, double until_s) {
  while (backend.time_s() < until_s - 1e-9) {
    const double tick = std::floor(backend.time_s() / control_period_s + 1e-6);
    for (std::size_t robot = 0; robot < backend.robots(); ++robot) {
      backend.set_joint_targets(robot, own_gait(robot, backend.joint_angles(robot).size(), tick * control_period_s));
    }
    backend.advance_to((tick + 1.0) * control_period_s);
  }
}

/// Largest difference of any coordinate of any robot: root position, quaternion, joint angles.
inline double largest_difference(const backend::Mujoco& a, const backend::Mujoco& b) {
  double largest = 0.0;
  for (std::size_t robot = 0; robot < a.robots(); ++robot) {
    const Pose one = a.pose(robot);
    const Pose other = b.pose(robot);
    largest = std::max(largest, (one.position_m - other.position_m).cwiseAbs().maxCoeff());
    largest = std::max(largest, (one.orientation.coeffs() - other.orientation.coeffs()).cwiseAbs().maxCoeff());
    for (std::size_t i = 0; i < a.joint_angles(robot).size(); ++i) {
      largest = std::max(largest, std::abs(a.joint_angles(robot)[i] - b.joint_angles(robot)[i]));
    }
  }
  return largest;
}

}  // namespace trophic::test
