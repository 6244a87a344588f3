// SPDX-License-Identifier: MIT
// The models that an experiment names, from their files.
#pragma once

#include <stdexcept>
#include <string>
#include <trophic/ecology/world.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/load/arena.hpp>
#include <trophic/load/gait.hpp>
#include <trophic/load/robot.hpp>

namespace trophic {

/// Loads and checks the three models. Throws std::runtime_error for a file that is missing or broken and std::invalid_argument
/// for content that does not fit, each naming file and key.
[[nodiscard]] inline Habitat load_habitat(const World& world) {
  Habitat habitat{.robot = load_robot(world.robot), .arena = load_arena(world.arena), .gait = {}};
  const std::string& gait = world.gait.empty() ? habitat.robot.gait : world.gait;
  if (gait.empty()) throw std::invalid_argument{"world.gait: must be given, as robot \"" + world.robot + "\" names none"};
  habitat.gait = load_gait(gait);
  check_fit(habitat.gait, habitat.robot);
  return habitat;
}

}  // namespace trophic
