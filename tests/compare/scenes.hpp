// SPDX-License-Identifier: MIT
// Small robots with textbook motions, and quantities that any backend gives.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <trophic/backend/contract.hpp>
#include <trophic/habitat/link_frames.hpp>

namespace trophic::compare {

[[nodiscard]] inline Link solid_box(std::string name, const Eigen::Vector3d& extents_m, const Eigen::Vector3d& centre_m,
                                    double mass_kg) {
  const Eigen::Vector3d squared = extents_m.cwiseAbs2();
  const Eigen::Vector3d moments = mass_kg / 12.0 * (Eigen::Vector3d::Constant(squared.sum()) - squared);
  Link link;
  link.name = std::move(name);
  link.mass_kg = mass_kg;
  link.centre_of_mass_m = centre_m;
  link.inertia_kgm2 = moments.asDiagonal();
  link.boxes = {{.part = "box", .half_extents_m = extents_m / 2.0, .centre_m = centre_m, .mass_kg = mass_kg}};
  return link;
}

/// A robot of one box.
[[nodiscard]] inline RobotModel brick(const Eigen::Vector3d& extents_m, double mass_kg, double friction) {
  RobotModel robot;
  robot.name = "brick";
  robot.links = {solid_box("box", extents_m, Eigen::Vector3d::Zero(), mass_kg)};
  robot.friction = friction;
  robot.rest_height_m = extents_m.z() / 2.0;
  robot.bounding_radius_m = extents_m.norm() / 2.0;
  return robot;
}

/// An arm that hangs next to a heavy tower and turns about the tower's x axis. At angle 0 it points `start_rad` away from
/// straight down, towards +y; its centre of mass is `length_m` from the hinge.
struct Pendulum {
  static constexpr double mass_kg = 0.1;
  static constexpr double length_m = 0.08;
  double start_rad = std::numbers::pi / 3.0;
  double range_rad = 2.8;
  Servo servo{.position_gain = 0.0, .velocity_gain = 0.0};

  [[nodiscard]] static Eigen::Vector3d extents_m() { return {0.03, 0.03, 0.12}; }
  [[nodiscard]] static double inertia_kgm2() {
    return mass_kg * (length_m * length_m + (extents_m().y() * extents_m().y() + extents_m().z() * extents_m().z()) / 12.0);
  }

  [[nodiscard]] RobotModel robot() const {
    RobotModel robot = brick({0.4, 0.4, 0.4}, 20.0, 1.0);
    robot.name = "pendulum";
    Link arm = solid_box("arm", extents_m(), {0.0, 0.0, -length_m}, mass_kg);
    arm.parent = 0;
    arm.offset_m = {0.25, 0.0, 0.1};
    arm.rotation = Eigen::AngleAxisd{start_rad, Eigen::Vector3d::UnitX()};
    robot.links.push_back(arm);
    robot.hinges.push_back({.name = "hinge", .axis = Eigen::Vector3d::UnitX(), .range_rad = range_rad, .servo = servo});
    robot.hinge_neighbours.resize(1);
    robot.bounding_radius_m = 0.6;
    return robot;
  }
};

template <Backend B>
[[nodiscard]] Eigen::Vector3d centre_of_mass_m(const B& backend, const RobotModel& robot, std::size_t index) {
  const auto frames = link_frames(robot, backend.pose(index), backend.joint_angles(index));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    sum += robot.links[i].mass_kg * (frames[i] * robot.links[i].centre_of_mass_m);
  }
  return sum / robot.mass_kg();
}

/// A height field that is one tilted plane: it rises with `slope` (tangent) along `direction`. Its cells are smaller than a
/// brick: MuJoCo finds one contact point per triangle, and a brick on one point rocks and slips.
[[nodiscard]] inline Arena tilted_plane(double slope, const Eigen::Vector2d& direction, double friction) {
  Arena arena;
  arena.name = "tilted_plane";
  arena.friction = friction;
  arena.half_side_m = 8.0;
  arena.extent_m = 40.0;
  constexpr int cells = 160;
  HeightField field{.nodes = cells + 1, .half_extent_m = 10.0, .height_m = {}};
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) {
      const Eigen::Vector2d at_m =
          Eigen::Vector2d{x, y} * (2.0 * field.half_extent_m / cells) - Eigen::Vector2d::Constant(field.half_extent_m);
      field.height_m.push_back(slope * direction.dot(at_m));
    }
  }
  const double lowest_m = *std::min_element(field.height_m.begin(), field.height_m.end());
  for (double& height_m : field.height_m) height_m -= lowest_m;
  arena.height_field = field;
  return arena;
}

/// Where the tilted plane lies at the origin.
[[nodiscard]] inline double height_at_origin_m(const Arena& arena) {
  return arena.height_field->height_m[arena.height_field->height_m.size() / 2];
}

/// Steps one by one until `until_s`, calling `look(time_s)` after each.
template <Backend B, class Look>
void watch(B& backend, double until_s, double timestep_s, Look&& look) {
  while (backend.time_s() < until_s - 1e-9) {
    backend.advance_to(backend.time_s() + timestep_s);
    look(backend.time_s());
  }
}

}  // namespace trophic::compare
