// SPDX-License-Identifier: MIT
// Spiders that stand at places on the floor, as sensors of the body read them.
#pragma once

#include <trophic/habitat/load/robot.hpp>
#include <trophic/population/body_reading.hpp>

namespace trophic::test {

struct StandingSpiders final : BodyReading {
  RobotModel model = load_robot("spider");
  std::vector<Pose> roots;
  std::vector<double> angles_rad = std::vector<double>(model.hinges.size(), 0.0);  ///< of each

  explicit StandingSpiders(const std::vector<GroundPose>& places) {
    for (const GroundPose& at : places) roots.push_back({.position_m = {at.x_m, at.y_m, model.rest_height_m}});
  }
  [[nodiscard]] const RobotModel& robot(BodyIndex) const override { return model; }
  [[nodiscard]] Pose root(BodyIndex body) const override { return roots[body]; }
  [[nodiscard]] std::span<const double> joint_angles_rad(BodyIndex) const override { return angles_rad; }
};

}  // namespace trophic::test
