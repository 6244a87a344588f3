// SPDX-License-Identifier: MIT
// Definitions of kinematic.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <trophic/backend/kinematic.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/support/units.hpp>

namespace trophic::backend {

TROPHIC_INLINE std::vector<std::string> Kinematic::remarks(const Physics&) {
  return {
      "physics.timestep_s, physics.integrator and physics.gravity_m_s2 have no effect: kinematic moves points on exact arcs, "
      "by backend.timestep_s"};
}

TROPHIC_INLINE Kinematic::Kinematic(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts,
                                    const Physics& physics, const Params& params)
    : params_{params},
      speed_m_s_{params.speed_scale * robot.walk.speed_m_s},
      turn_rate_per_rad_{params.turn_scale * robot.walk.turn_rate_per_rad},
      forward_rad_{robot.forward_rad},
      height_m_{robot.rest_height_m},
      limit_m_{arena.half_side_m - params.radius_m} {
  validate(physics, "physics");
  validate(params, "kinematic");
  if (!(robot.walk.speed_m_s > 0.0)) {
    throw std::invalid_argument{"robot " + robot.name + ": walk.speed_m_s = " + number_text(robot.walk.speed_m_s) +
                                ": must be > 0 for a backend without joints; trophic measure-gait --walk measures it"};
  }
  if (!(robot.walk.turn_rate_per_rad > 0.0)) {
    throw std::invalid_argument{"robot " + robot.name + ": walk.turn_rate_per_rad = " +
                                number_text(robot.walk.turn_rate_per_rad) + ": must be > 0, else brains cannot turn the robot"};
  }
  if (!(limit_m_ > 0.0)) {
    throw std::invalid_argument{"kinematic.radius_m = " + number_text(params.radius_m) + ": must be < the arena's half side, " +
                                number_text(arena.half_side_m)};
  }
  if (starts.empty()) throw std::invalid_argument{"robots = 0: must be >= 1"};
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const GroundPose start = ground_pose(starts[i], forward_rad_);
    const bool is_inside = std::abs(start.x_m) <= arena.half_side_m && std::abs(start.y_m) <= arena.half_side_m;
    if (!is_inside) {
      throw std::invalid_argument{"start pose " + std::to_string(i) + " at (" + number_text(start.x_m) + ", " +
                                  number_text(start.y_m) + "): must be finite and within +-" + number_text(arena.half_side_m)};
    }
    if (!std::isfinite(start.heading_rad)) {
      throw std::invalid_argument{"start pose " + std::to_string(i) + ": its heading must be finite"};
    }
    state_.bodies.push_back({.x_m = start.x_m, .y_m = start.y_m, .heading_rad = start.heading_rad});
  }
}

TROPHIC_INLINE void Kinematic::advance_to(double time_s) {
  while (this->time_s() < time_s - 1e-9) {
    for (Body& body : state_.bodies) step(body);
    ++state_.steps;
  }
}

TROPHIC_INLINE Pose Kinematic::pose(std::size_t robot) const {
  const Body& body = state_.bodies.at(robot);
  const double half_yaw_rad = 0.5 * (body.heading_rad - forward_rad_);
  return {.position_m = {body.x_m, body.y_m, height_m_},
          .orientation = {std::cos(half_yaw_rad), 0.0, 0.0, std::sin(half_yaw_rad)}};
}

TROPHIC_INLINE void Kinematic::set_target_angle(std::size_t robot, double target_angle_rad) {
  if (!std::isfinite(target_angle_rad)) {
    throw std::invalid_argument{"target_angle_rad = " + number_text(target_angle_rad) + ": must be finite"};
  }
  state_.bodies.at(robot).target_angle_rad = target_angle_rad;
}

TROPHIC_INLINE void Kinematic::restore(const State& state) {
  if (state.bodies.size() != state_.bodies.size()) {
    throw std::invalid_argument{"state.bodies.size() = " + std::to_string(state.bodies.size()) + ": must be " +
                                std::to_string(state_.bodies.size())};
  }
  state_ = state;
}

TROPHIC_INLINE void Kinematic::step(Body& body) const {
  const double half_turn_rad = -0.5 * turn_rate_per_rad_ * body.target_angle_rad * params_.timestep_s;
  const double shortening = half_turn_rad == 0.0 ? 1.0 : std::sin(half_turn_rad) / half_turn_rad;
  const double chord_m = speed_m_s_ * params_.timestep_s * shortening;
  const double direction_rad = body.heading_rad + half_turn_rad;
  body.x_m = std::clamp(body.x_m + chord_m * std::cos(direction_rad), -limit_m_, limit_m_);
  body.y_m = std::clamp(body.y_m + chord_m * std::sin(direction_rad), -limit_m_, limit_m_);
  body.heading_rad = wrap_angle(direction_rad + half_turn_rad);
}

}  // namespace trophic::backend
