// SPDX-License-Identifier: MIT
// Checks the start poses of robots with bodies.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/params/params.hpp>

namespace trophic::backend {

/// Throws std::invalid_argument unless the pose is inside the walls, outside obstacles and within the arena's extent in height,
/// and the norm of its orientation is > 0.5 and < 2.
inline void check_start_pose(std::size_t robot, const Pose& start, const Arena& arena) {
  const Eigen::Vector3d& at = start.position_m;
  const double norm = start.orientation.norm();
  const std::string pose = "start pose " + std::to_string(robot) + " ";
  const std::string place = pose + "at (" + number_text(at.x()) + ", " + number_text(at.y()) + ", " + number_text(at.z()) + "): ";
  const auto within = [](double value, double most) { return std::abs(value) <= most; };
  if (!within(at.x(), arena.half_side_m) || !within(at.y(), arena.half_side_m)) {
    throw std::invalid_argument{place + "must be finite and within +-" + number_text(arena.half_side_m)};
  }
  if (!is_clear(arena, {.x_m = at.x(), .y_m = at.y()}, 0.0)) throw std::invalid_argument{place + "must not be in an obstacle"};
  if (!within(at.z(), arena.extent_m)) {
    throw std::invalid_argument{place + "its height must be finite and within +-" + number_text(arena.extent_m)};
  }
  if (norm > 0.5 && norm < 2.0) return;
  throw std::invalid_argument{pose + "has an orientation of norm " + number_text(norm) + ": must be > 0.5 and < 2"};
}

}  // namespace trophic::backend
