// SPDX-License-Identifier: MIT
// Definitions of habitat.hpp.
#pragma once

#include <Eigen/Core>
#include <string>
#include <trophic/habitat/habitat.hpp>
#include <trophic/params/params.hpp>

namespace trophic {

TROPHIC_INLINE std::string numbers_text(const Habitat& habitat) {
  std::string text;
  const auto add = [&](double value) { text += number_text(value) + " "; };
  const auto add_all = [&](const auto& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) add(matrix.data()[i]);
  };
  for (const Link& link : habitat.robot.links) {
    add(link.parent);
    add_all(link.offset_m);
    add_all(link.rotation.coeffs());
    add(link.mass_kg);
    add_all(link.centre_of_mass_m);
    add_all(link.inertia_kgm2);
    for (const Box& box : link.boxes) {
      add_all(box.half_extents_m);
      add_all(box.centre_m);
      add_all(box.orientation.coeffs());
    }
  }
  for (const Hinge& hinge : habitat.robot.hinges) {
    add_all(hinge.axis);
    add(hinge.range_rad);
    add_all(hinge.grid_position.cast<double>().eval());
    add(hinge.servo.position_gain);
    add(hinge.servo.velocity_gain);
    add(hinge.servo.target_limit_rad);
  }
  add(habitat.robot.friction);
  add(habitat.robot.forward_rad);
  add(habitat.arena.half_side_m);
  add(habitat.arena.extent_m);
  add(habitat.arena.friction);
  if (habitat.arena.height_field) {
    add(habitat.arena.height_field->half_extent_m);
    for (const double height_m : habitat.arena.height_field->height_m) add(height_m);
  }
  add_all(habitat.gait.internal);
  add_all(habitat.gait.coupling);
  return text;
}

TROPHIC_INLINE std::string walk_text(const RobotModel& robot) {
  return number_text(robot.walk.speed_m_s) + " " + number_text(robot.walk.turn_rate_per_rad) + " ";
}

}  // namespace trophic
