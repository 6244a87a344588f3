// SPDX-License-Identifier: MIT
// A picture: robots, lines on the floor, flashes, names, a caption, a legend. Places and colours only; no rule, no
// recording, no OpenGL.
#pragma once

#include <algorithm>
#include <memory>
#include <tools/recording/species_colour.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic::film {

/// A robot in a picture: its body, and round it a ring on the floor with a pointer in its heading.
struct RobotLook {
  Pose root;
  std::vector<double> joint_angles_rad;  ///< in the order of the hinges; empty: all 0
  Colour colour{};
  bool filled = false;                          ///< the ring's inside
  bool is_marked = false;                       ///< a second, dark ring round the first
  std::shared_ptr<const RobotModel> body = {};  ///< its own; null: that of the drawing
};

/// A line on the floor; dashed if it joins two robots.
struct FloorLine {
  double x0_m = 0.0;
  double y0_m = 0.0;
  double x1_m = 0.0;
  double y1_m = 0.0;
  Colour colour{};
  float opacity = 1.0F;
  bool is_dashed = false;
};

/// A circle on the floor.
struct Circle {
  double x_m = 0.0;
  double y_m = 0.0;
  double radius_m = 0.0;
  Colour colour{};
};

/// A widening ring where an individual has just died; red for a catch.
struct Flash {
  double x_m = 0.0;
  double y_m = 0.0;
  double rings = 1.0;  ///< its radius, in radii of a robot's ring
  bool is_catch = false;
};

/// The name of a robot, next to it and on no other.
struct Name {
  std::size_t robot = 0;  ///< its number in the picture
  std::string text;
};

/// A mark and its meaning.
struct LegendEntry {
  enum class Mark { species, filled, hollow, catch_, death, marked, trail, sight, food, zone, reach };
  Mark mark = Mark::species;
  Colour colour{};
  std::string text;
};

/// A square of the floor, whose colour is its foods: each from 0 to 1, the most.
struct FoodTile {
  double x_m = 0.0;  ///< of its centre
  double y_m = 0.0;
  double half_side_m = 0.0;
  std::vector<float> foods = {};
};

/// Numbers over time, which goes from 0 to 1 in the stretch that is shown.
struct Curve {
  Colour colour{};
  std::vector<std::array<double, 2>> points;
};

struct Picture {
  std::vector<FoodTile> food;  ///< they are all of the floor; none in a world without food
  std::vector<RobotLook> robots;
  std::vector<FloorLine> lines;
  std::vector<Circle> circles;
  std::vector<Flash> flashes;
  std::vector<Name> names;
  std::vector<LegendEntry> legend;
  std::vector<Curve> curves;
  double most = 0.0;  ///< the number at the top of the curves
  std::string title;
  std::string caption;
  bool has_scale = false;  ///< a bar of metres, as long as it is where the camera looks
  bool is_small = false;   ///< names and caption in large letters
};

/// The mark of a catch.
inline constexpr Colour catch_colour{0.76F, 0.0F, 0.18F};
/// The edge of a zone on the floor.
inline constexpr Colour zone_colour{0.29F, 0.35F, 0.41F};

/// The radius of a robot's ring round its body, where a pixel is so large. A robot whose ring would have fewer pixels is drawn
/// larger.
[[nodiscard]] inline double ring_radius_m(const RobotModel& robot, double pixel_m) {
  constexpr double least_pixels = 11.0;
  return std::max(1.15 * robot.bounding_radius_m, least_pixels * pixel_m);
}

}  // namespace trophic::film
