// SPDX-License-Identifier: MIT
// Definitions of validate_robot.hpp.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <stdexcept>
#include <trophic/habitat/physics.hpp>
#include <trophic/habitat/reach.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/habitat/validate_robot.hpp>

namespace trophic {

TROPHIC_INLINE void validate(const RobotModel& robot) {
  const auto fail = [&](const std::string& what) { throw std::invalid_argument{"robot " + robot.name + ": " + what}; };
  const auto check = [&](const std::string& name, double value, bool good, const std::string& rule) {
    if (!std::isfinite(value) || !good) fail(name + " = " + number_text(value) + ": " + rule);
  };
  if (robot.links.size() != robot.hinges.size() + 1) {
    fail("links.size() = " + std::to_string(robot.links.size()) +
         ": must be hinges.size() + 1 = " + std::to_string(robot.hinges.size() + 1));
  }
  if (robot.hinge_neighbours.size() != robot.hinges.size()) {
    fail("hinge_neighbours.size() = " + std::to_string(robot.hinge_neighbours.size()) +
         ": must be hinges.size() = " + std::to_string(robot.hinges.size()));
  }
  check("friction", robot.friction, robot.friction >= 0.0 && robot.friction <= most_friction, "must be >= 0 and <= 10");
  check("forward_rad", robot.forward_rad, std::abs(robot.forward_rad) <= std::numbers::pi, "must be within -pi and pi");
  check("rest_height_m", robot.rest_height_m, robot.rest_height_m > 0.0, "must be > 0");
  validate(robot.walk, "robot " + robot.name + ": walk");
  check("bounding_radius_m", robot.bounding_radius_m, robot.bounding_radius_m > 0.0, "must be > 0");

  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    const std::string at = "links[" + std::to_string(i) + "].";
    const bool parent_ok = i == 0 ? link.parent == -1 : link.parent >= 0 && link.parent < static_cast<int>(i);
    if (!parent_ok) {
      fail(at + "parent = " + std::to_string(link.parent) +
           (i == 0 ? ": must be -1" : ": must be >= 0 and < " + std::to_string(i)));
    }
    if (!link.offset_m.allFinite() || !link.centre_of_mass_m.allFinite())
      fail(at + "offset_m and centre_of_mass_m: must be finite");
    check(at + "rotation norm", link.rotation.norm(), std::abs(link.rotation.norm() - 1.0) < 1e-9, "must be 1");
    check(at + "mass_kg", link.mass_kg, link.mass_kg > 0.0, "must be > 0");
    double box_mass_kg = 0.0;
    for (const Box& box : link.boxes) {
      check(at + box.part + " mass_kg", box.mass_kg, box.mass_kg > 0.0, "must be > 0");
      check(at + box.part + " half extent_m", box.half_extents_m.minCoeff(), box.half_extents_m.minCoeff() > 0.0, "must be > 0");
      if (!box.centre_m.allFinite()) fail(at + box.part + " centre_m: must be finite");
      check(at + box.part + " orientation norm", box.orientation.norm(), std::abs(box.orientation.norm() - 1.0) < 1e-9,
            "must be 1");
      box_mass_kg += box.mass_kg;
    }
    check(at + "mass_kg", link.mass_kg, std::abs(link.mass_kg - box_mass_kg) <= 1e-9 * link.mass_kg,
          "must be the sum of its boxes, " + number_text(box_mass_kg));
    if (!link.inertia_kgm2.allFinite() || !link.inertia_kgm2.isApprox(link.inertia_kgm2.transpose(), 1e-9)) {
      fail(at + "inertia_kgm2: must be finite and symmetric");
    }
    const Eigen::Vector3d moments =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>{link.inertia_kgm2, Eigen::EigenvaluesOnly}.eigenvalues();
    check(at + "inertia_kgm2 smallest principal moment", moments[0], moments[0] > 0.0, "must be > 0");
    check(at + "inertia_kgm2 largest principal moment", moments[2], moments[2] <= (moments[0] + moments[1]) * (1.0 + 1e-9),
          "must be <= the sum of the other two");
  }
  const double reach = reach_m(robot);
  check("bounding_radius_m", robot.bounding_radius_m, robot.bounding_radius_m >= (1.0 - 1e-9) * reach,
        "must be >= " + number_text(reach) + ", the reach of its boxes");

  std::set<std::string> names;
  for (std::size_t i = 0; i < robot.hinges.size(); ++i) {
    const Hinge& hinge = robot.hinges[i];
    const std::string at = "hinges[" + std::to_string(i) + "].";
    if (!names.insert(hinge.name).second) fail(at + "name = " + hinge.name + ": must be unique");
    check(at + "axis norm", hinge.axis.norm(), std::abs(hinge.axis.norm() - 1.0) < 1e-9, "must be 1");
    check(at + "range_rad", hinge.range_rad, hinge.range_rad > 0.0, "must be > 0");
    check(at + "servo.position_gain", hinge.servo.position_gain, hinge.servo.position_gain >= 0.0, "must be >= 0");
    check(at + "servo.velocity_gain", hinge.servo.velocity_gain, hinge.servo.velocity_gain >= 0.0, "must be >= 0");
    check(at + "servo.target_limit_rad", hinge.servo.target_limit_rad, hinge.servo.target_limit_rad > 0.0, "must be > 0");
    const auto& neighbours = robot.hinge_neighbours[i];
    if (std::adjacent_find(neighbours.begin(), neighbours.end(), std::greater_equal<>{}) != neighbours.end()) {
      fail("hinge_neighbours[" + std::to_string(i) + "]: must be ascending");
    }
    for (const std::size_t other : neighbours) {
      const bool mutual =
          other < robot.hinges.size() && other != i && std::ranges::binary_search(robot.hinge_neighbours[other], i);
      if (!mutual)
        fail("hinge_neighbours[" + std::to_string(i) + "] = " + std::to_string(other) +
             ": must be another hinge that lists this one too");
    }
  }
}

}  // namespace trophic
