// SPDX-License-Identifier: MIT
// Definitions of checks.hpp.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <trophic/ecology/checks.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/support/control_characters.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic::detail {

TROPHIC_INLINE void check_prey(const FoodWeb& web, BodyIndex hunter, Species eater, BodyIndex victim, Species eaten) {
  if (web.eats(eater, eaten)) return;
  throw RuleError{"capture", "hunter " + std::to_string(hunter) + " and victim " + std::to_string(victim) + ": species " +
                                 web.name(eater) + " does not eat " + web.name(eaten)};
}

TROPHIC_INLINE void check_one_each(std::string_view slot, std::string_view what, std::size_t returned, std::size_t robots) {
  if (returned == robots) return;
  throw RuleError{slot, std::to_string(returned) + " " + std::string{what} + ": must be " + std::to_string(robots) +
                            ", the number of robots"};
}

TROPHIC_INLINE void check_names(const FoodWeb& web) {
  for (Species species = 0; species < web.size(); ++species) {
    const std::string& name = web.name(species);
    if (is_plain(name) && name.find_first_of(",\"") == std::string::npos) continue;
    throw RuleError{"community", "the name of species " + std::to_string(species) + ", \"" + name +
                                     "\": must have no comma, quote or control character"};
  }
}

TROPHIC_INLINE void check_places(std::span<const GroundPose> places, std::size_t robots) {
  check_one_each("placement", "places", places.size(), robots);
  for (std::size_t body = 0; body < places.size(); ++body) {
    const GroundPose& place = places[body];
    if (std::isfinite(place.x_m) && std::isfinite(place.y_m) && std::isfinite(place.heading_rad)) continue;
    throw RuleError{"placement", "the place of body " + std::to_string(body) + ": must be finite"};
  }
}

TROPHIC_INLINE void check_parent(const FoodWeb& web, const reproduction::Vacancy& vacancy, const Ancestor& parent,
                                 const std::optional<std::string>& demand) {
  check_index("parent", "a parent of species", parent.species, web.size());
  if (demand) throw RuleError{"parent", "individual " + std::to_string(parent.id) + " as a parent: must have " + *demand};
  if (!vacancy.successor || parent.species == *vacancy.successor) return;
  throw RuleError{"parent", "individual " + std::to_string(parent.id) + ", a " + web.name(parent.species) +
                                ", as the parent of a " + web.name(*vacancy.successor) + ": must be of its offspring's species"};
}

TROPHIC_INLINE void check_lives(std::string_view slot, std::string_view what, BodyIndex body,
                                std::span<const Individual> robots) {
  check_index(slot, what, body, robots.size());
  if (robots[body].lives()) return;
  throw RuleError{slot, std::string{what} + " " + std::to_string(body) + ": must be a body with an individual"};
}

TROPHIC_INLINE void check_captures(std::span<const death::Capture> captures, std::span<const Individual> robots) {
  for (const death::Capture& capture : captures) {
    check_lives("capture", "hunter", capture.hunter, robots);
    check_lives("capture", "victim", capture.victim, robots);
  }
}

TROPHIC_INLINE void check_starving(const death::Starving& starving, std::span<const Individual> robots) {
  for (const BodyIndex hunter : starving.exempt) check_lives("starvation", "exempt hunter", hunter, robots);
  for (const BodyIndex victim : starving.victims) check_lives("starvation", "victim", victim, robots);
}

TROPHIC_INLINE void check_sacrifices(std::span<const death::Sacrifice> sacrifices, std::span<const Individual> robots) {
  for (const death::Sacrifice& sacrifice : sacrifices) check_lives("minimum_predators", "victim", sacrifice.victim, robots);
}

TROPHIC_INLINE void check_saved_poses(std::span<const GroundPose> poses, std::size_t robots) {
  Archive::require(poses.size() == robots, "another number of robots");
  for (const GroundPose& pose : poses) {
    const bool is_somewhere = std::abs(pose.x_m) < 1e9 && std::abs(pose.y_m) < 1e9 && std::isfinite(pose.heading_rad);
    Archive::require(is_somewhere, "a robot without a finite position");
  }
}

TROPHIC_INLINE std::size_t checked_spare_bodies(std::size_t spare, std::size_t robots) {
  if (spare < robots) return spare;
  throw RuleError{"recruitment",
                  "spare_bodies = " + std::to_string(spare) + ": must be < " + std::to_string(robots) + ", the number of robots"};
}

TROPHIC_INLINE void check_recruit(const FoodWeb& web, const reproduction::Recruit& recruit, std::span<const Individual> robots,
                                  const std::optional<std::string>& demand) {
  check_index("recruitment", "body", recruit.body, robots.size());
  check_index("recruitment", "species", recruit.species, web.size());
  if (robots[recruit.body].lives()) {
    throw RuleError{"recruitment", "a birth in body " + std::to_string(recruit.body) + ": must be a body without an individual"};
  }
  if (!recruit.parent) return;
  const Ancestor& parent = *recruit.parent;
  const std::string who = "individual " + std::to_string(parent.id) + " as a parent: must ";
  if (parent.species != recruit.species) throw RuleError{"recruitment", who + "be of the newborn's species"};
  if (demand) throw RuleError{"recruitment", who + "have " + *demand};
}

}  // namespace trophic::detail
