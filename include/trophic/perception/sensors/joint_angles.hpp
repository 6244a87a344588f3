// SPDX-License-Identifier: MIT
// Proprioception: the angles of the robot's own joints.
#pragma once

#include <trophic/perception/sensors/contract.hpp>
#include <trophic/population/body_reading.hpp>

namespace trophic::perception::sensors {

/// Rule: the angle of each of the first `count` hinges divided by its range, in about [-1, 1]; 0 for a hinge that the body does
/// not have. Refused on a backend without joints.   Reads: own joints.   Random draws: 0.
template <std::size_t count>
struct JointAngles {
  static constexpr std::string_view name = "joint_angles";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = count;
  static constexpr bool needs_joints = true;

  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    std::array<double, size> values{};
    if (view.bodies == nullptr) return values;
    const std::span<const double> angles_rad = view.bodies->joint_angles_rad(self);
    const std::vector<Hinge>& hinges = view.bodies->robot(self).hinges;
    for (std::size_t i = 0; i < std::min(size, angles_rad.size()); ++i) values[i] = angles_rad[i] / hinges[i].range_rad;
    return values;
  }
};
static_assert(OwnSensor<JointAngles<1>>);

}  // namespace trophic::perception::sensors
