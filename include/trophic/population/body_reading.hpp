// SPDX-License-Identifier: MIT
// Bodies in an engine with joints, for sensors of the body.
#pragma once

#include <span>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/population/individual.hpp>

namespace trophic {

/// Readings of bodies at the moment at which robots decide.
class BodyReading {
 public:
  virtual ~BodyReading() = default;
  [[nodiscard]] virtual const RobotModel& robot(BodyIndex body) const = 0;
  [[nodiscard]] virtual Pose root(BodyIndex body) const = 0;  ///< of the root link, m
  /// Joint angles in radians, in the order of RobotModel::hinges.
  [[nodiscard]] virtual std::span<const double> joint_angles_rad(BodyIndex body) const = 0;
};

}  // namespace trophic
