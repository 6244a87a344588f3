// SPDX-License-Identifier: MIT
// Balance: the tilt of the robot's own root link.
#pragma once

#include <trophic/perception/sensors/contract.hpp>
#include <trophic/population/body_reading.hpp>

namespace trophic::perception::sensors {

/// Rule: the angle between the root link's z axis and the vertical, divided by pi: 0 upright, 1 on its back. Refused on a backend
/// without joints.   Reads: own pose.   Random draws: 0.
struct Tilt {
  static constexpr std::string_view name = "tilt";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  static constexpr bool needs_joints = true;

  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    if (view.bodies == nullptr) return {0.0};
    const double upright = (view.bodies->root(self).orientation.normalized() * Eigen::Vector3d::UnitZ()).z();
    return {std::acos(std::clamp(upright, -1.0, 1.0)) / std::numbers::pi};
  }
};
static_assert(OwnSensor<Tilt>);

}  // namespace trophic::perception::sensors
