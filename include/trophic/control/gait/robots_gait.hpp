// SPDX-License-Identifier: MIT
// Every robot walks with the gait that was evolved for it beforehand.
#pragma once

#include <trophic/control/gait/contract.hpp>

namespace trophic::control::gait {

/// Rule: a robot has the gait that its file or `ecology.gait` names (Sec. "Robot Controller").   Reads: nothing.   Random draws:
/// 0.
struct RobotsGait {
  static constexpr std::string_view name = "robots_gait";
  static constexpr std::string_view source = "paper, Sec. \"Robot Controller\"";
  [[nodiscard]] Gait express(std::span<const double>, const RobotModel& robot, const Habitat& habitat) const {
    if (const Gait* gait = habitat.gait_of(robot)) return *gait;
    throw std::invalid_argument{"robot " + robot.name + ": has no gait of its own; use a rule Gait that gives every body a gait"};
  }
};
static_assert(GaitRule<RobotsGait>);

}  // namespace trophic::control::gait
