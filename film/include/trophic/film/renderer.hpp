// SPDX-License-Identifier: MIT
// Draws robots in their arena by MuJoCo's renderer, without a screen (OSMesa). Knows places and colours, no rule and no
// recording.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <trophic/film/image.hpp>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <vector>

namespace trophic::film {

/// Red, green, blue, each in [0, 1].
using Colour = std::array<float, 3>;

/// A robot as it is to be seen: its body, and round it a ring on the floor that points where it heads.
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

/// A widening ring where something has just happened.
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

/// Looks at a point from a distance; azimuth 90 degrees looks along +y, elevation -90 straight down.
struct Camera {
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();
  double distance_m = 10.0;
  double azimuth_deg = 90.0;
  double elevation_deg = -50.0;
};

/// How fine a picture is.
enum class Quality {
  fast,  ///< each pixel drawn once
  fine   ///< drawn twice as large and scaled down: smooth edges
};

/// One at a time in a thread.
class Renderer {
 public:
  /// Of pictures of `width` times `height` pixels, both even, 16 to 4096. Throws std::invalid_argument for another size and
  /// std::runtime_error where there is no OpenGL.
  Renderer(const RobotModel& robot, const Arena& arena, std::size_t width, std::size_t height, Quality quality);
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  [[nodiscard]] Image draw(const Picture& picture, const Camera& camera);

  /// Sees the whole arena from the south, or from above.
  [[nodiscard]] Camera whole_arena() const;
  [[nodiscard]] Camera from_above() const;
  /// Looks at a robot from near.
  [[nodiscard]] Camera near(const Eigen::Vector3d& at_m) const;

 private:
  class Drawing;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace trophic::film
