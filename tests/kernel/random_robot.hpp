// SPDX-License-Identifier: MIT
// Random robots: trees of the project's modules, and trees of anything that a RobotModel can describe.
#pragma once

#include <stdexcept>
#include <trophic/habitat/body/build.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::test {

/// A core with up to `modules` random hinges and bricks.
[[nodiscard]] inline RobotModel random_module_robot(Rng& rng, std::size_t modules) {
  body::Design design;
  design.name = "random";
  for (std::size_t i = 0; i < modules; ++i) {
    const std::size_t parent = rng.index(design.modules.modules().size());
    const auto face = body::all_faces.at(rng.index(4));
    const auto type = rng.chance(0.5) ? body::ModuleType::hinge : body::ModuleType::brick;
    try {
      design.modules.attach(parent, face, type, static_cast<int>(rng.index(4)));
    } catch (const std::invalid_argument&) {
      continue;  // no such face, or no room
    }
  }
  return body::build(design);
}

/// A rotation by any angle about any axis.
[[nodiscard]] inline Eigen::Quaterniond random_rotation(Rng& rng) {
  const Eigen::Vector4d q(rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1));
  return Eigen::Quaterniond{q.normalized()};
}

/// Links of one or two skewed boxes with offset inertias on skewed hinges, numbered depth first.
[[nodiscard]] inline RobotModel random_skew_robot(Rng& rng, std::size_t links) {
  RobotModel robot;
  robot.name = "skew";
  robot.friction = rng.uniform(0.3, 1.5);
  std::vector<std::size_t> chain;
  double reach_m = 0.3;
  for (std::size_t i = 0; i < links; ++i) {
    Link& link = robot.links.emplace_back();
    link.name = "link" + std::to_string(i);
    if (i > 0) {
      chain.resize(1 + rng.index(chain.size()));
      link.parent = static_cast<int>(chain.back());
      const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(links);
      link.offset_m = Eigen::Vector3d(0.25 * std::cos(angle_rad), 0.25 * std::sin(angle_rad), rng.uniform(-0.05, 0.05));
      link.rotation = random_rotation(rng);
      Hinge& hinge = robot.hinges.emplace_back();
      hinge.axis = random_rotation(rng) * Eigen::Vector3d::UnitX();
      hinge.range_rad = rng.uniform(0.5, 1.5);
      hinge.servo = {rng.uniform(1, 8), rng.uniform(0.01, 0.1), rng.uniform(0.5, 1.5)};
      reach_m += 0.3;
    }
    chain.push_back(i);
    const std::size_t boxes = 1 + rng.index(2);
    for (std::size_t b = 0; b < boxes; ++b) {
      Box& box = link.boxes.emplace_back();
      for (int k = 0; k < 3; ++k) box.half_extents_m[k] = rng.uniform(0.01, 0.05);
      for (int k = 0; k < 3; ++k) box.centre_m[k] = rng.uniform(-0.03, 0.03);
      box.orientation = rng.chance(0.3) ? Eigen::Quaterniond::Identity() : random_rotation(rng);
    }
    link.mass_kg = rng.uniform(0.05, 0.5);
    for (int k = 0; k < 3; ++k) link.centre_of_mass_m[k] = rng.uniform(-0.02, 0.02);
    const Eigen::Matrix3d axes = random_rotation(rng).toRotationMatrix();
    const Eigen::Vector3d moments =
        link.mass_kg * 1e-3 * Eigen::Vector3d(rng.uniform(1, 1.9), rng.uniform(1, 1.9), rng.uniform(1, 1.9));
    link.inertia_kgm2 = axes * moments.asDiagonal() * axes.transpose();
  }
  robot.bounding_radius_m = reach_m;
  robot.rest_height_m = 0.1;
  return robot;
}

}  // namespace trophic::test
