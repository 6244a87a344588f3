// SPDX-License-Identifier: MIT
// What an ecology lives in and with: the robot, the ground, the gait.
#pragma once

#include <string>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// The models that `World` names, loaded; or any others, made by a program.
struct Habitat {
  RobotModel robot;
  Arena arena;
  Gait gait;
};

/// Every number of a habitat as text, for fingerprints: two habitats with the same text move alike where robots have joints.
[[nodiscard]] std::string numbers_text(const Habitat& habitat);

/// The numbers by which a robot moves where it has no joints.
[[nodiscard]] std::string walk_text(const RobotModel& robot);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/habitat.ipp>
#endif
