// SPDX-License-Identifier: MIT
// Definitions of trial.hpp.
#include <tools/gait_evolution/trial.hpp>

namespace trophic::gait_evolution {

Pilot steady(double target_angle_rad) {
  return [target_angle_rad](double, const GroundPose&) { return target_angle_rad; };
}

double bearing_of_minus_x_rad(const GroundPose& now) {
  return -wrap_angle(std::numbers::pi - now.heading_rad);
}

Arena endless_floor() {
  return {.name = "endless_floor", .half_side_m = 1000.0, .extent_m = 2000.0, .friction = 1.0, .height_field = {}};
}

}  // namespace trophic::gait_evolution
