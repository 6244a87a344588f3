// SPDX-License-Identifier: MIT
// Contents of a picture: robots, lines on the floor, flashes, a caption. Places and colours only; no rule, no recording, no
// OpenGL.
#pragma once

#include <algorithm>
#include <string>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/population/species_colour.hpp>
#include <vector>

namespace trophic::drawing {

/// A robot in a picture: its body, and round it a ring on the floor with a pointer in its heading.
struct RobotLook {
  Pose root;
  std::vector<double> joint_angles_rad;  ///< in the order of the hinges; empty: all 0
  Colour colour{};
  bool filled = false;     ///< the ring's inside
  bool is_marked = false;  ///< a second, dark ring round the first
};

/// A line on the floor.
struct FloorLine {
  double x0_m = 0.0;
  double y0_m = 0.0;
  double x1_m = 0.0;
  double y1_m = 0.0;
  Colour colour{};
  float opacity = 1.0F;
};

/// A widening ring at the place of a recent event.
struct Flash {
  double x_m = 0.0;
  double y_m = 0.0;
  double radius_m = 0.0;
};

struct Picture {
  std::vector<RobotLook> robots;
  std::vector<FloorLine> lines;
  std::vector<Flash> flashes;
  std::string caption;
};

/// The radius of a robot's ring: round its body, and large enough for a picture of the whole arena.
[[nodiscard]] inline double ring_radius_m(const RobotModel& robot, const Arena& arena) {
  return std::max(1.15 * robot.bounding_radius_m, 0.021 * arena.half_side_m);
}

}  // namespace trophic::drawing
