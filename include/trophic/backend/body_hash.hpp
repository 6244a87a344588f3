// SPDX-License-Identifier: MIT
// Identifies the bodies to which a saved state of an engine belongs.
#pragma once

#include <bit>
#include <span>
#include <stdexcept>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/support/word_hash.hpp>

namespace trophic::backend {

/// Returns a hash of the parameters that determine how a body moves, which exclude names, gaits and the order of module parts.
[[nodiscard]] inline std::uint64_t body_hash(const RobotModel& robot) {
  WordHash hash;
  const auto add = [&](double number) { hash.add(std::bit_cast<std::uint64_t>(number + 0.0)); };
  const auto add_all = [&](const auto& matrix) {
    for (const double number : std::span{matrix.data(), static_cast<std::size_t>(matrix.size())}) add(number);
  };
  add(robot.friction);
  add(robot.bounding_radius_m);
  for (const Link& link : robot.links) {
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
  for (const Hinge& hinge : robot.hinges) {
    add_all(hinge.axis);
    add(hinge.range_rad);
    add(hinge.servo.position_gain);
    add(hinge.servo.velocity_gain);
    add(hinge.servo.target_limit_rad);
  }
  return hash.value();
}

/// Throws std::invalid_argument that names the first robot whose body differs. Both arguments are hashes of robots' bodies.
inline void require_same_bodies(std::span<const std::uint64_t> of_state, std::span<const std::uint64_t> own) {
  if (of_state.size() != own.size()) {
    throw std::invalid_argument{"state.bodies.size() = " + std::to_string(of_state.size()) + ": must be " +
                                std::to_string(own.size())};
  }
  for (std::size_t robot = 0; robot < own.size(); ++robot) {
    if (of_state[robot] == own[robot]) continue;
    throw std::invalid_argument{"state.bodies[" + std::to_string(robot) + "]: robot " + std::to_string(robot) +
                                " has another body: must be that of the state, by embody()"};
  }
}

}  // namespace trophic::backend
