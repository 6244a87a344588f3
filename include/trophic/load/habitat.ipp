// SPDX-License-Identifier: MIT
// Definitions of habitat.hpp.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/load/arena.hpp>
#include <trophic/load/gait.hpp>
#include <trophic/load/habitat.hpp>
#include <trophic/load/robot.hpp>

namespace trophic {

TROPHIC_INLINE Habitat load_habitat(const World& world, std::string_view installed) {
  Habitat habitat{.robot = load_robot(world.robot, installed), .arena = load_arena(world.arena, installed), .gait = {}};
  const std::string& gait = world.gait.empty() ? habitat.robot.gait : world.gait;
  if (gait.empty()) throw std::invalid_argument{"world.gait: must be given, as robot \"" + world.robot + "\" names none"};
  habitat.gait = load_gait(gait, installed);
  check_fit(habitat.gait, habitat.robot);
  return habitat;
}

}  // namespace trophic
