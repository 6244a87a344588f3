// SPDX-License-Identifier: MIT
// Definitions of habitat.hpp.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>

namespace trophic {

TROPHIC_INLINE Habitat load_habitat(const EcologyParams& ecology, std::string_view installed) {
  Habitat habitat{
      .robot = load_robot(ecology.robot, installed), .arena = load_arena(ecology.arena, installed, ecology.robots), .gait = {}};
  const std::string& gait = ecology.gait.empty() ? habitat.robot.gait : ecology.gait;
  if (gait.empty()) throw std::invalid_argument{"ecology.gait: must be given, as robot \"" + ecology.robot + "\" names none"};
  habitat.gait = load_gait(gait, installed);
  check_fit(habitat.gait, habitat.robot);
  return habitat;
}

}  // namespace trophic
