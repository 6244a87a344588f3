// SPDX-License-Identifier: MIT
// Bodies as an engine with joints has them, for sensors of the body.
#pragma once

#include <span>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/population/individual.hpp>

namespace trophic {

/// Read at the moment at which robots decide.
class BodyReading {
 public:
  virtual ~BodyReading() = default;
  [[nodiscard]] virtual const RobotModel& robot(BodyIndex body) const = 0;
  [[nodiscard]] virtual Pose root(BodyIndex body) const = 0;  ///< of the root link, m
  /// In the order of RobotModel::hinges, rad.
  [[nodiscard]] virtual std::span<const double> joint_angles_rad(BodyIndex body) const = 0;
};

}  // namespace trophic
