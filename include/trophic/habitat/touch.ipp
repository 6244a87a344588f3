// SPDX-License-Identifier: MIT
// Definitions of touch.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <trophic/habitat/link_frames.hpp>
#include <trophic/habitat/touch.hpp>

namespace trophic {

TROPHIC_INLINE std::vector<PlacedBox> placed_boxes(const RobotModel& robot, const Pose& root,
                                                   std::span<const double> joint_angles_rad) {
  std::vector<PlacedBox> boxes;
  const std::vector<Eigen::Isometry3d> frames = link_frames(robot, root, joint_angles_rad);
  for (std::size_t link = 0; link < frames.size(); ++link) {
    for (const Box& box : robot.links[link].boxes) {
      const Eigen::Matrix3d axes = frames[link].linear() * box.orientation.toRotationMatrix();
      boxes.push_back({.centre_m = frames[link] * box.centre_m,
                       .half_edges_m = axes * box.half_extents_m.asDiagonal(),
                       .radius_m = box.half_extents_m.norm()});
    }
  }
  return boxes;
}

TROPHIC_INLINE bool touch(const PlacedBox& a, const PlacedBox& b) {
  const Eigen::Vector3d between_m = b.centre_m - a.centre_m;
  if (between_m.squaredNorm() > (a.radius_m + b.radius_m) * (a.radius_m + b.radius_m)) return false;
  const auto separates = [&](const Eigen::Vector3d& axis) {
    const double reach =
        (axis.transpose() * a.half_edges_m).cwiseAbs().sum() + (axis.transpose() * b.half_edges_m).cwiseAbs().sum();
    return std::abs(axis.dot(between_m)) > reach;
  };
  for (int i = 0; i < 3; ++i) {
    if (separates(a.half_edges_m.col(i)) || separates(b.half_edges_m.col(i))) return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d axis = a.half_edges_m.col(i).cross(b.half_edges_m.col(j));
      const double parallel = 1e-9 * a.half_edges_m.col(i).norm() * b.half_edges_m.col(j).norm();
      if (axis.norm() > parallel && separates(axis)) return false;
    }
  }
  return true;
}

TROPHIC_INLINE bool touch(std::span<const PlacedBox> a, std::span<const PlacedBox> b) {
  return std::ranges::any_of(
      a, [&](const PlacedBox& one) { return std::ranges::any_of(b, [&](const PlacedBox& other) { return touch(one, other); }); });
}

TROPHIC_INLINE bool touch_wall(std::span<const PlacedBox> boxes, double half_side_m) {
  return std::ranges::any_of(boxes, [&](const PlacedBox& box) {
    const auto reach_m = [&](int axis) { return std::abs(box.centre_m[axis]) + box.half_edges_m.row(axis).cwiseAbs().sum(); };
    return std::max(reach_m(0), reach_m(1)) >= half_side_m;
  });
}

TROPHIC_INLINE bool touch(const PlacedBox& box, const Obstacle& obstacle) {
  if (distance_m(obstacle, box.centre_m.x(), box.centre_m.y()) > box.radius_m) return false;
  if (box.centre_m.z() - box.half_edges_m.row(2).cwiseAbs().sum() > obstacle.height_m) return false;
  if (distance_m(obstacle, box.centre_m.x(), box.centre_m.y()) <= 0.0) return true;
  for (int edge = 0; edge < 12; ++edge) {
    const int axis = edge / 4;
    const auto sign = [&](int bit) { return (edge >> bit) % 2 == 0 ? 1.0 : -1.0; };
    const Eigen::Vector3d middle =
        box.centre_m + sign(0) * box.half_edges_m.col((axis + 1) % 3) + sign(1) * box.half_edges_m.col((axis + 2) % 3);
    const Eigen::Vector3d from = middle - box.half_edges_m.col(axis);
    const Eigen::Vector3d to = middle + box.half_edges_m.col(axis);
    const Obstacle side{.x_m = from.x(), .y_m = from.y(), .to_x_m = to.x(), .to_y_m = to.y(), .radius_m = obstacle.radius_m};
    const bool near_an_end = distance_m(obstacle, from.x(), from.y()) <= 0.0 ||
                             distance_m(side, obstacle.x_m, obstacle.y_m) <= 0.0 ||
                             distance_m(side, obstacle.to_x_m, obstacle.to_y_m) <= 0.0;
    if (near_an_end || distance_m(obstacle, to.x(), to.y()) <= 0.0) return true;
    const auto left_of = [](const Obstacle& line, double x_m, double y_m) {
      return (line.to_x_m - line.x_m) * (y_m - line.y_m) > (line.to_y_m - line.y_m) * (x_m - line.x_m);
    };
    const bool crosses = left_of(obstacle, from.x(), from.y()) != left_of(obstacle, to.x(), to.y()) &&
                         left_of(side, obstacle.x_m, obstacle.y_m) != left_of(side, obstacle.to_x_m, obstacle.to_y_m);
    if (crosses) return true;
  }
  return false;
}

TROPHIC_INLINE bool touch(std::span<const PlacedBox> boxes, std::span<const Obstacle> obstacles) {
  return std::ranges::any_of(obstacles, [&](const Obstacle& one) {
    return std::ranges::any_of(boxes, [&](const PlacedBox& box) { return touch(box, one); });
  });
}

}  // namespace trophic
