// SPDX-License-Identifier: MIT
// Whether the kernel steps as the MuJoCo does with which it is compiled: for versions that are newer than all that were tried.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <trophic/backend/contract.hpp>
#include <trophic/backend/mujoco/islands.hpp>
#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/backend/mujoco/one_model.hpp>
#include <trophic/params/params.hpp>

namespace trophic::backend::mujoco {

/// The largest difference of a coordinate after the steps of `kernel_disagreement`. Rounding makes 1e-15, physics of another kind
/// 1e-9 or more.
inline constexpr double agreement = 1e-12;

/// A trunk with an arm on a hinge.
[[nodiscard]] inline RobotModel trunk_with_arm() {
  const auto box = [](const std::string& name, const Eigen::Vector3d& half_m, double mass_kg) {
    Link link;
    link.name = name;
    link.mass_kg = mass_kg;
    const Eigen::Vector3d squared = half_m.cwiseAbs2();
    link.inertia_kgm2 = (mass_kg / 3.0 * (Eigen::Vector3d::Constant(squared.sum()) - squared)).asDiagonal();
    link.boxes = {{.part = name, .half_extents_m = half_m, .mass_kg = mass_kg}};
    return link;
  };
  RobotModel robot;
  robot.name = "trunk_with_arm";
  robot.links = {box("trunk", {0.1, 0.08, 0.03}, 0.5), box("arm", {0.05, 0.02, 0.02}, 0.1)};
  robot.links[1].parent = 0;
  robot.links[1].offset_m = {0.16, 0.0, 0.0};
  robot.hinges = {{.name = "hinge", .axis = Eigen::Vector3d::UnitY(), .range_rad = 0.5, .servo = {}}};
  robot.hinge_neighbours.resize(1);
  robot.rest_height_m = 0.03;
  robot.bounding_radius_m = 0.25;
  return robot;
}

/// Two such robots, one leaning on the other, take some steps by the kernel and, in one model, by `mj_step`: the largest
/// difference of a coordinate, or of a velocity over a step.
[[nodiscard]] inline double kernel_disagreement(const Physics& of_kernel, const Physics& of_engine) {
  const RobotModel robot = trunk_with_arm();
  const Arena arena;
  Islands islands{robot, arena, of_kernel, 1, BoxDepth::engine, std::make_unique<Lanes>(BoxDepth::engine, 1)};
  OneModel one{robot, arena, of_engine, 2, BoxDepth::engine};
  RobotStates start{islands.layout(), 2};
  start.set_root(0,
                 {{0.0, 0.0, 0.034}, Eigen::Quaterniond{Eigen::AngleAxisd{0.05, Eigen::Vector3d{1.0, 0.5, 0.2}.normalized()}}});
  start.set_root(1,
                 {{0.03, 0.05, 0.101}, Eigen::Quaterniond{Eigen::AngleAxisd{0.4, Eigen::Vector3d{0.2, 0.3, 1.0}.normalized()}}});
  constexpr std::array velocity{0.2, -0.1, 0.1, 1.0, -2.0, 3.0, 1.5};
  Rows targets_rad{2, 1};
  for (std::size_t i = 0; i < 2; ++i) {
    start.numbers(i)[7] = 0.51;  // beyond the hinge's limit
    std::ranges::copy(velocity, start.numbers(i).begin() + 8);
    targets_rad[i][0] = -0.5;
  }
  constexpr std::size_t steps = 5;
  RobotStates by_kernel = start;
  RobotStates by_engine = start;
  static_cast<void>(islands.advance(start, targets_rad, steps, by_kernel));
  static_cast<void>(one.advance(start, targets_rad, steps, by_engine));
  if (islands.engine_share() > 0.0) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 15; ++k) {
      const double scale = k < 8 ? 1.0 : of_kernel.timestep_s;
      const double difference = scale * std::abs(by_kernel.numbers(i)[k] - by_engine.numbers(i)[k]);
      if (!(difference <= largest)) largest = difference;
    }
  }
  return largest;
}

/// The same, for both integrators.
[[nodiscard]] inline double kernel_disagreement() {
  const Physics euler{};
  const Physics rk4{.timestep_s = 0.01, .integrator = Integrator::rk4};
  return std::max(kernel_disagreement(euler, euler), kernel_disagreement(rk4, rk4));
}

/// Throws std::runtime_error if that is not rounding.
inline void require_agreement(double disagreement) {
  if (disagreement < agreement) return;
  throw std::runtime_error{std::string{"MuJoCo "} + mj_versionString() +
                           " is newer than all versions that trophic was tried with, and "
                           "its steps differ from those of trophic's kernel by " +
                           number_text(disagreement) + ": use an older one, or backend.stepping = islands"};
}

}  // namespace trophic::backend::mujoco
