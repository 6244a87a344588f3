// SPDX-License-Identifier: MIT
// A newborn appears upright in its own body, where the dead one stood.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <trophic/initialization/embodiment/contract.hpp>

namespace trophic::initialization::embodiment {

/// Rule: a newborn's body appears where the old one stood, with the same heading, upright, with joint angles 0 and its feet on
/// the floor. If it would reach into a wall, it is moved inwards. If it would touch another robot, it appears at the nearest free
/// place on rings with a spacing of step_m and 16 places each, up to two of its radii away; if none is free, it appears straight
/// above and falls. `diverged`: what happens if an engine can no longer compute a body's motion.   Reads: the boxes of the robots
/// near it.   Random draws: 0.
struct StandsUp {
  static constexpr std::string_view name = "stands_up";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double step_m = 0.05;
    double gap_m = 0.005;
    Divergence diverged = Divergence::ends_individual;
    static constexpr auto fields() {
      return std::tuple{
          field("step_m", &Params::step_m, between(0.01, 1.0), "distance between the rings of positions that are tried"),
          field("gap_m", &Params::gap_m, between(0.0, 0.1), "minimum distance to other robots and to walls"),
          field("diverged", &Params::diverged, "effect of a body whose motion diverges: ends_run or ends_individual")};
    }
  };
  Params params;

  [[nodiscard]] Divergence divergence() const { return params.diverged; }

  [[nodiscard]] Pose set_down(const GroundPose& place, const RobotModel& robot, const Arena& arena,
                              std::span<const PlacedBox> others) const {
    Pose pose{
        .position_m = {place.x_m, place.y_m, robot.rest_height_m},
        .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{place.heading_rad - robot.forward_rad, Eigen::Vector3d::UnitZ()}}};
    std::vector<PlacedBox> boxes = placed_boxes(robot, pose, {});
    for (PlacedBox& box : boxes) grow(box);
    const auto move_to = [&](const Eigen::Vector3d& position_m) {
      const Eigen::Vector3d step_m = position_m - pose.position_m;
      for (PlacedBox& box : boxes) box.centre_m += step_m;
      pose.position_m = position_m;
    };
    move_to(inside(pose.position_m, boxes, arena.half_side_m));
    const Eigen::Vector3d first_m = pose.position_m;
    const auto rings = static_cast<std::size_t>(std::ceil(2.0 * robot.bounding_radius_m / params.step_m));
    for (std::size_t ring = 0; ring <= rings; ++ring) {
      for (std::size_t place_on_ring = 0; place_on_ring < (ring == 0 ? 1U : places_on_ring); ++place_on_ring) {
        const double angle_rad = place.heading_rad + 2.0 * std::numbers::pi * static_cast<double>(place_on_ring) / places_on_ring;
        const double radius_m = static_cast<double>(ring) * params.step_m;
        const Eigen::Vector3d there_m = first_m + radius_m * Eigen::Vector3d{std::cos(angle_rad), std::sin(angle_rad), 0.0};
        move_to(there_m);
        if (ring > 0 && touch_wall(boxes, arena.half_side_m)) continue;
        if (touch(boxes, arena.obstacles)) continue;
        if (!touch(boxes, others)) return pose;
      }
    }
    move_to(first_m);
    while (touch(boxes, others)) move_to(pose.position_m + Eigen::Vector3d{0.0, 0.0, params.step_m});
    return pose;
  }

 private:
  static constexpr std::size_t places_on_ring = 16;

  /// Enlarges a box by the gap on each side.
  void grow(PlacedBox& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double half_m = box.half_edges_m.col(axis).norm();
      box.half_edges_m.col(axis) *= (half_m + params.gap_m) / half_m;
    }
    box.radius_m += 2.0 * params.gap_m;
  }

  /// Returns the position, moved inwards until all boxes are within the arena if it is wide enough.
  [[nodiscard]] static Eigen::Vector3d inside(Eigen::Vector3d position_m, std::span<const PlacedBox> boxes, double half_side_m) {
    for (int axis = 0; axis < 2; ++axis) {
      double low_m = half_side_m;
      double high_m = -half_side_m;
      for (const PlacedBox& box : boxes) {
        const double reach_m = box.half_edges_m.row(axis).cwiseAbs().sum();
        low_m = std::min(low_m, box.centre_m[axis] - reach_m);
        high_m = std::max(high_m, box.centre_m[axis] + reach_m);
      }
      if (high_m - low_m >= 2.0 * half_side_m) {
        position_m[axis] -= (low_m + high_m) / 2.0;
      } else if (high_m >= half_side_m) {
        position_m[axis] -= (high_m - half_side_m) * (1.0 + 1e-9) + 1e-9;
      } else if (low_m <= -half_side_m) {
        position_m[axis] += (-half_side_m - low_m) * (1.0 + 1e-9) + 1e-9;
      }
    }
    return position_m;
  }
};
static_assert(Embodiment<StandsUp>);

}  // namespace trophic::initialization::embodiment
