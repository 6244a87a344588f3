// SPDX-License-Identifier: MIT
// The viewpoint of a window: turned, moved and zoomed with a mouse, over the whole arena or next to one robot.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/pictures/drawing/camera.hpp>

namespace trophic::watch {

class Eye {
 public:
  [[nodiscard]] const drawing::Camera& camera() const { return camera_; }

  void see_whole(const Arena& arena, double aspect) { camera_ = drawing::whole_arena(arena, aspect); }
  void see_from_above(const Arena& arena, double aspect) { camera_ = drawing::from_above(arena, aspect); }
  void come_near(const RobotModel& robot, const Eigen::Vector3d& at_m) { camera_ = drawing::near(robot, at_m); }
  /// Follows a robot.
  void look_at(const Eigen::Vector3d& at_m) { camera_.at_m = {at_m.x(), at_m.y(), 0.0}; }

  /// Far enough to see two robots that are so far apart.
  void keep_in_view(double apart_m) { camera_.distance_m += 1.6 * apart_m; }

  /// By a part of the window's height, to the right and up.
  void turn(double right, double up) {
    camera_.azimuth_deg = std::remainder(camera_.azimuth_deg - 180.0 * right, 360.0);
    camera_.elevation_deg = std::clamp(camera_.elevation_deg + 120.0 * up, -90.0, -5.0);
  }
  /// Moves as if the floor was dragged.
  void shift(double right, double up) {
    const double azimuth = camera_.azimuth_deg * std::numbers::pi / 180.0;
    const double scale_m = 2.0 * drawing::half_height() * camera_.distance_m;
    camera_.at_m += scale_m * (right * Eigen::Vector3d{-std::sin(azimuth), std::cos(azimuth), 0.0} -
                               up * Eigen::Vector3d{std::cos(azimuth), std::sin(azimuth), 0.0});
  }
  /// One notch of a wheel nearer or, negative, farther.
  void zoom(double notches) { camera_.distance_m = std::clamp(camera_.distance_m * std::pow(0.88, notches), 0.2, 2000.0); }

 private:
  drawing::Camera camera_;
};

}  // namespace trophic::watch
