// SPDX-License-Identifier: MIT
// Sets the bodies of newborns down among the other robots.
#pragma once

#include <cstddef>
#include <span>
#include <trophic/backend/any_backend.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/habitat/touch.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/phenotype.hpp>
#include <trophic/support/units.hpp>
#include <vector>

namespace trophic {

/// The robot in a body; the habitat's if bodies do not differ.
[[nodiscard]] inline const RobotModel& robot_in(BodyIndex body, std::span<const Phenotype> phenotypes, const Habitat& habitat) {
  return phenotypes.empty() || !phenotypes[body].robot ? habitat.robot : *phenotypes[body].robot;
}

/// The boxes of the robots that a body of this reach at `place` could touch or be set down next to. `bodies`: how many stand; the
/// others, and `self`, are left out.
[[nodiscard]] inline std::vector<PlacedBox> boxes_near(const GroundPose& place, double reach_m, BodyIndex self,
                                                       std::size_t bodies, const AnyBackend& backend,
                                                       std::span<const Phenotype> phenotypes, const Habitat& habitat) {
  std::vector<PlacedBox> near;
  for (BodyIndex other = 0; other < bodies; ++other) {
    if (other == self) continue;
    const RobotModel& robot = robot_in(other, phenotypes, habitat);
    const Pose root = backend.pose(other);
    const GroundPose there{.x_m = root.position_m.x(), .y_m = root.position_m.y()};
    if (distance_m(place, there) > 3.0 * reach_m + robot.bounding_radius_m) continue;
    const auto boxes = placed_boxes(robot, root, backend.joint_angles(other));
    near.insert(near.end(), boxes.begin(), boxes.end());
  }
  return near;
}

}  // namespace trophic
