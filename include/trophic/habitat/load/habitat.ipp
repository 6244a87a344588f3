// SPDX-License-Identifier: MIT
// Definitions of habitat.hpp.
#pragma once

#include <stdexcept>
#include <string>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <utility>

namespace trophic {

TROPHIC_INLINE Habitat load_habitat(const EcologyParams& ecology, const ModelNames& names, std::string_view installed) {
  Habitat habitat = load_habitat(ecology, installed);
  if (names.needs_design) habitat.design = load_design(ecology.robot, installed);
  for (const std::string& name : names.robots) {
    if (habitat.robot_named(name) != nullptr) continue;
    NamedRobot named{.name = name, .design = load_design(name, installed), .robot = {}, .gait = {}};
    named.robot = body::build(named.design);
    if (named.robot.gait.empty())
      throw std::invalid_argument{"robot \"" + name + "\": must name its gait, because rules give this body to individuals"};
    named.gait = load_gait(named.robot.gait, installed);
    check_fit(named.gait, named.robot);
    habitat.robots.push_back(std::move(named));
  }
  for (const std::string& name : names.gaits) {
    if (habitat.gait_named(name) == nullptr) habitat.gaits.push_back({.name = name, .gait = load_gait(name, installed)});
  }
  return habitat;
}

TROPHIC_INLINE Habitat load_habitat(const EcologyParams& ecology, std::string_view installed) {
  Habitat habitat{
      .robot = load_robot(ecology.robot, installed), .arena = load_arena(ecology.arena, installed, ecology.robots), .gait = {}};
  const std::string& gait = ecology.gait.empty() ? habitat.robot.gait : ecology.gait;
  if (gait.empty())
    throw std::invalid_argument{"ecology.gait: must be given, because robot \"" + ecology.robot + "\" names none"};
  habitat.gait = load_gait(gait, installed);
  check_fit(habitat.gait, habitat.robot);
  return habitat;
}

}  // namespace trophic
