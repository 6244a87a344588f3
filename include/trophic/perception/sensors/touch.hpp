// SPDX-License-Identifier: MIT
// Touch: whether the robot's body is in contact with a wall or another robot.
#pragma once

#include <trophic/habitat/touch.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/population/body_reading.hpp>

namespace trophic::perception::sensors {

/// Rule: two inputs, each 1 or 0: whether a box of the body reaches a wall or an obstacle, and whether it touches another robot.
/// Bodies have the size of their boxes; the engine's contacts are not used. Refused on a backend without joints.   Reads: the
/// bodies of robots, arena.   Random draws: 0.
struct Touch {
  static constexpr std::string_view name = "touch";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 2;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  static constexpr bool needs_joints = true;

  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    if (view.bodies == nullptr) return {0.0, 0.0};
    const std::vector<PlacedBox> own = boxes_of(self, view);
    const bool at_wall = touch_wall(own, view.arena.half_side_m) || trophic::touch(own, view.arena.obstacles);
    const double radius_m = view.bodies->robot(self).bounding_radius_m;
    const auto touches = [&](BodyIndex other) {
      if (other == self || !view.robots[other].lives()) return false;
      const double reach_m = radius_m + view.bodies->robot(other).bounding_radius_m;
      return view.distance_m(self, other) <= reach_m && trophic::touch(own, boxes_of(other, view));
    };
    bool at_robot = false;
    for (BodyIndex other = 0; other < view.robots.size() && !at_robot; ++other) at_robot = touches(other);
    return {at_wall ? 1.0 : 0.0, at_robot ? 1.0 : 0.0};
  }

 private:
  [[nodiscard]] static std::vector<PlacedBox> boxes_of(BodyIndex body, const View& view) {
    return placed_boxes(view.bodies->robot(body), view.bodies->root(body), view.bodies->joint_angles_rad(body));
  }
};
static_assert(OwnSensor<Touch>);

}  // namespace trophic::perception::sensors
