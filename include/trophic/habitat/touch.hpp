// SPDX-License-Identifier: MIT
// Finds robots that touch each other or a wall, by the shapes of their boxes: the same for every engine.
#pragma once

#include <span>
#include <trophic/habitat/obstacle.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// A box in the world: its centre, half of each edge as a vector, and the radius of its bounding sphere.
struct PlacedBox {
  Eigen::Vector3d centre_m;
  Eigen::Matrix3d half_edges_m;  ///< columns
  double radius_m = 0.0;
};

/// All boxes of a robot. `joint_angles_rad` as in `link_frames`.
[[nodiscard]] std::vector<PlacedBox> placed_boxes(const RobotModel& robot, const Pose& root,
                                                  std::span<const double> joint_angles_rad);

/// Whether two boxes overlap or touch: no axis separates them, neither a face's normal nor the product of two edges (separating
/// axis theorem [gottschalk1996]). Edges that are parallel within rounding give no axis; the faces' normals replace it.
[[nodiscard]] bool touch(const PlacedBox& a, const PlacedBox& b);

/// Whether some box of one robot touches some box of the other.
[[nodiscard]] bool touch(std::span<const PlacedBox> a, std::span<const PlacedBox> b);

/// Whether a robot reaches |x| or |y| = `half_side_m`, where an arena's walls or slopes begin.
[[nodiscard]] bool touch_wall(std::span<const PlacedBox> boxes, double half_side_m);

/// Whether a box reaches an obstacle, seen from above, below its top. A pillar inside the box, away from its edges and its
/// centre, is not detected, because engines do not let that happen.
[[nodiscard]] bool touch(const PlacedBox& box, const Obstacle& obstacle);

/// Whether a robot reaches an obstacle.
[[nodiscard]] bool touch(std::span<const PlacedBox> boxes, std::span<const Obstacle> obstacles);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/touch.ipp>
#endif
