// SPDX-License-Identifier: MIT
// Targeted steering of the published gait in MuJoCo, with the target angles -0.7, 0 and 0.7 rad.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <tools/gait_evolution/trial.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>

using namespace trophic;

namespace {

void check_steering(const char* robot_name, const Physics& physics) {
  const RobotModel robot = load_robot(robot_name);
  const Gait gait = load_gait("spider_published");
  std::array<double, 3> rates_rad_s{};
  for (const double side : {-1.0, 0.0, 1.0}) {
    const auto track = gait_evolution::try_out(robot, gait, control::steering::TargetedSteering{}, {.duration_s = 60.0}, physics,
                                               backend::Mujoco::Params{}, gait_evolution::steady(0.7 * side));
    const auto [forward_m_s, left_m_s] = track.forward_and_left_m_s();
    rates_rad_s.at(static_cast<std::size_t>(side + 1.0)) = track.turn_rate_rad_s();
    MESSAGE(robot.name << ", target angle " << 0.7 * side << " rad: " << forward_m_s << " m/s forward, " << left_m_s
                       << " m/s to the left, " << track.turn_rate_rad_s() << " rad/s");
    CHECK(forward_m_s > 0.025);
    CHECK(forward_m_s < 0.07);
    CHECK(std::abs(left_m_s) < 0.45 * forward_m_s);  // along the forward axis
  }
  const auto [left, straight, right] = rates_rad_s;
  CHECK(left - straight > 0.024);
  CHECK(right - straight < -0.024);
  CHECK(std::abs(straight) < 0.03);
}

}  // namespace

TEST_CASE("steering: spider at the paper's timestep -> turns to both sides") {
  check_steering("spider", {});
}

TEST_CASE("steering: released spider with the released physics -> turns to both sides") {
  check_steering("spider_released", {.timestep_s = 0.012, .integrator = Integrator::rk4});
}
