// SPDX-License-Identifier: MIT
// Robots in ODE, set up for tests.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <trophic/backend/ode.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

namespace trophic::test {

struct OdeWorld {
  RobotModel robot = load_robot("spider");
  Arena arena = load_arena("walled_square");
  Physics physics;
  backend::Ode::Params params;
  std::vector<Pose> starts{{.position_m = {0.0, 0.0, load_robot("spider").rest_height_m}}};

  [[nodiscard]] backend::Ode make() const { return backend::Ode{robot, arena, starts, physics, params}; }
};

/// A crowd on a grid so dense that neighbours' legs touch.
inline std::vector<Pose> crowd(std::size_t side, double spacing_m, double height_m) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < side * side; ++i) {
    const double x_m = spacing_m * static_cast<double>(i % side);
    const double y_m = spacing_m * static_cast<double>(i / side);
    const Eigen::AngleAxisd turned{0.7 * static_cast<double>(i), Eigen::Vector3d::UnitZ()};
    poses.push_back({.position_m = {x_m, y_m, height_m}, .orientation = Eigen::Quaterniond{turned}});
  }
  return poses;
}

/// Every robot swings its legs in its own rhythm.
inline void walk(backend::Ode& backend, double until_s) {
  for (double time_s = backend.time_s(); time_s < until_s - 1e-9; time_s = backend.time_s()) {
    for (std::size_t robot = 0; robot < backend.robots(); ++robot) {
      const double phase = time_s * (2.0 + 0.3 * static_cast<double>(robot));
      const std::array<double, 4> targets_rad{0.8 * std::sin(phase), 0.8 * std::cos(phase), -0.6 * std::sin(phase),
                                              0.7 * std::cos(phase + 1.0)};
      backend.set_joint_targets(robot, targets_rad);
    }
    backend.advance_to(time_s + 1.0 / 60.0);
  }
}

}  // namespace trophic::test
