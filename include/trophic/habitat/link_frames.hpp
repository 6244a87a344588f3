// SPDX-License-Identifier: MIT
// The frames of all links of a robot, given its root and its joint angles.
#pragma once

#include <span>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// Forward kinematics: the frame of each link in the world, in the model's order. `joint_angles_rad` has one angle per hinge, in
/// the model's order; if empty, all are 0.
[[nodiscard]] std::vector<Eigen::Isometry3d> link_frames(const RobotModel& robot, const Pose& root,
                                                         std::span<const double> joint_angles_rad);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/link_frames.ipp>
#endif
