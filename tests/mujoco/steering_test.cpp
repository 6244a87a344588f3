// SPDX-License-Identifier: MIT
// Targeted steering of the published gait in MuJoCo: three spiders far apart with the target angles -0.7, 0 and 0.7 rad.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <trophic/backend/mujoco.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

using namespace trophic;

namespace {

/// A robot's walk of 60 s. Legs make body and heading swing, hence the means over 10 s at both ends.
struct Walk {
  double turned_rad = 0.0;       ///< mean heading of the last 10 s minus that of the first, counter-clockwise
  double turn_rate_rad_s = 0.0;  ///< the same, a second
  double speed_m_s = 0.0;        ///< of the position averaged over 10 s, along its curve
  double direction_rad = 0.0;    ///< of that motion, relative to the forward axis, counter-clockwise
};

constexpr std::array<double, 3> target_angles_rad{-0.7, 0.0, 0.7};

std::array<Walk, 3> walk_60_s(const char* robot_name, const Physics& physics) {
  const RobotModel robot = load_robot(robot_name);
  std::vector<Pose> starts(3);
  for (std::size_t i = 0; i < 3; ++i) starts[i].position_m = {0.0, 6.0 * (static_cast<double>(i) - 1.0), robot.rest_height_m};
  backend::Mujoco backend{robot, load_arena("walled_square"), starts, physics, {}};
  locomotion::Locomotion<control::steering::TargetedSteering> locomotion{
      robot, load_gait("spider_published"), {}, 3, {.hz = 60.0}};

  constexpr std::size_t samples = 600;  // every 0.1 s
  constexpr std::size_t window = 100;   // 10 s
  std::array<std::vector<GroundPose>, 3> paths;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    locomotion.advance(backend, 6, target_angles_rad);
    for (std::size_t i = 0; i < 3; ++i) {
      GroundPose at = ground_pose(backend.pose(i), robot.forward_rad);
      if (!paths[i].empty()) {
        at.heading_rad = paths[i].back().heading_rad + wrap_angle(at.heading_rad - paths[i].back().heading_rad);
      }
      paths[i].push_back(at);
    }
  }
  std::array<Walk, 3> walks;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<GroundPose> smooth;
    for (std::size_t first = 0; first + window <= samples; ++first) {
      GroundPose mean;
      for (std::size_t k = first; k < first + window; ++k) {
        mean.x_m += paths[i][k].x_m / window;
        mean.y_m += paths[i][k].y_m / window;
        mean.heading_rad += paths[i][k].heading_rad / window;
      }
      smooth.push_back(mean);
    }
    double along_m = 0.0;
    double across_m = 0.0;
    for (std::size_t k = 1; k < smooth.size(); ++k) {
      const double step_m = distance_m(smooth[k - 1], smooth[k]);
      const double direction_rad = -bearing_rad(smooth[k - 1], smooth[k]);
      walks[i].speed_m_s += step_m;
      along_m += step_m * std::cos(direction_rad);
      across_m += step_m * std::sin(direction_rad);
    }
    const double duration_s = 0.1 * static_cast<double>(smooth.size() - 1);
    walks[i].turned_rad = smooth.back().heading_rad - smooth.front().heading_rad;
    walks[i].turn_rate_rad_s = walks[i].turned_rad / duration_s;
    walks[i].speed_m_s /= duration_s;
    walks[i].direction_rad = std::atan2(across_m, along_m);
    MESSAGE(robot.name << ", " << enum_name(physics.integrator) << " " << physics.timestep_s << " s, target angle "
                       << target_angles_rad[i] << " rad: " << walks[i].speed_m_s << " m/s, " << walks[i].turn_rate_rad_s
                       << " rad/s, direction " << walks[i].direction_rad * 180.0 / std::numbers::pi << " degrees");
  }
  return walks;
}

void check_steering(const std::array<Walk, 3>& walks) {
  const auto& [left, straight, right] = walks;
  CHECK(left.turned_rad - straight.turned_rad > 1.2);
  CHECK(right.turned_rad - straight.turned_rad < -1.2);
  CHECK(std::abs(straight.turn_rate_rad_s) < 0.03);
  for (const Walk& walk : walks) {
    CHECK(walk.speed_m_s > 0.025);
    CHECK(walk.speed_m_s < 0.07);
    CHECK(std::abs(walk.direction_rad) < 25.0 * std::numbers::pi / 180.0);  // along the forward axis
  }
}

}  // namespace

TEST_CASE("steering: spider at the paper's timestep -> turns to both sides") {
  check_steering(walk_60_s("spider", {}));
}

TEST_CASE("steering: released spider with the released physics -> turns to both sides") {
  check_steering(walk_60_s("spider_released", {.timestep_s = 0.012, .integrator = Integrator::rk4}));
}
