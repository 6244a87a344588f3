// SPDX-License-Identifier: MIT
// Definitions of habitat.hpp.
#pragma once

#include <algorithm>
#include <trophic/habitat/habitat.hpp>
#include <trophic/params/numbers_text.hpp>

namespace trophic {

TROPHIC_INLINE std::string numbers_text(const Habitat& habitat) {
  std::string text = numbers_text<Habitat>(habitat);
  if (habitat.design) {
    text +=
        numbers_text(*habitat.design) + numbers_text(habitat.design->servo) + numbers_text(habitat.design->root_density_kg_m3);
  }
  if (!habitat.arena.obstacles.empty()) text += numbers_text(habitat.arena.obstacles);
  for (const Zone& zone : habitat.arena.zones) text += zone.name + " " + numbers_text(zone);
  if (!habitat.robots.empty()) text += numbers_text(habitat.robots);
  if (!habitat.gaits.empty()) text += numbers_text(habitat.gaits);
  return text;
}

TROPHIC_INLINE const NamedRobot* Habitat::robot_named(std::string_view name) const {
  const auto found = std::ranges::find(robots, name, &NamedRobot::name);
  return found == robots.end() ? nullptr : &*found;
}

TROPHIC_INLINE const Gait* Habitat::gait_named(std::string_view name) const {
  const auto found = std::ranges::find(gaits, name, &NamedGait::name);
  return found == gaits.end() ? nullptr : &found->gait;
}

TROPHIC_INLINE const Gait* Habitat::gait_of(const RobotModel& one) const {
  const auto found = std::ranges::find(robots, one.name, [](const NamedRobot& named) { return named.robot.name; });
  if (found != robots.end()) return &found->gait;
  return one.name == robot.name ? &gait : nullptr;
}

}  // namespace trophic
