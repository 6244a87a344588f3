// SPDX-License-Identifier: MIT
// Definitions of fitness.hpp.
#include <tools/gait_evolution/fitness.hpp>

#include <algorithm>
#include <cmath>

namespace trophic::gait_evolution {

double DisplacementMinusX::fitness(const TryOut& try_out) const {
  const auto steered = [](double, const GroundPose& now) { return bearing_of_minus_x_rad(now); };
  return try_out(params.aim == Aim::none ? steady(0.0) : Pilot{steered}, 0.0).displacement_minus_x_m();
}

double SteeredDisplacement::fitness(const TryOut& try_out) const {
  return std::min(score_m(try_out, params.start_turn_rad), score_m(try_out, -params.start_turn_rad));
}

double SteeredDisplacement::score_m(const TryOut& try_out, double start_turn_rad) const {
  double next_decision_s = 0.0;
  double target_angle_rad = 0.0;
  const Pilot pilot = [=, *this](double time_s, const GroundPose& now) mutable {
    if (time_s >= next_decision_s - 1e-9) {
      target_angle_rad = bearing_of_minus_x_rad(now) < 0.0 ? -params.turn_angle_rad : params.turn_angle_rad;
      next_decision_s += params.decision_s;
    }
    return target_angle_rad;
  };
  const Track track = try_out(pilot, start_turn_rad);
  const auto facing = std::ranges::count_if(
      track.poses, [](const GroundPose& pose) { return std::abs(bearing_of_minus_x_rad(pose)) < std::numbers::pi / 2.0; });
  return track.displacement_minus_x_m() * static_cast<double>(facing) / static_cast<double>(track.poses.size());
}

}  // namespace trophic::gait_evolution
