// SPDX-License-Identifier: MIT
// Rejects invalid return values of rules: too few founders or places, catches of species that the hunter does not eat, unfit
// parents.
#pragma once

#include <trophic/death/capture/contract.hpp>
#include <trophic/death/minimum_predators/contract.hpp>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/recruitment/contract.hpp>
#include <trophic/support/control_characters.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic::detail {

/// Throws RuleError unless the hunter's species eats the victim's.
inline void check_prey(const FoodWeb& web, BodyIndex hunter, Species eater, BodyIndex victim, Species eaten) {
  if (web.eats(eater, eaten)) return;
  throw RuleError{"capture", "hunter " + std::to_string(hunter) + " and victim " + std::to_string(victim) + ": species " +
                                 web.name(eater) + " does not eat " + web.name(eaten)};
}

/// Throws RuleError if the rules fix a body's new species and the parent is of another one, or if the parent's genome violates
/// `demand` (Population::misfit).
inline void check_parent(const FoodWeb& web, const reproduction::Vacancy& vacancy, const Ancestor& parent,
                         const std::optional<std::string>& demand) {
  check_index("parent", "a parent of species", parent.species, web.size());
  if (demand) throw RuleError{"parent", "individual " + std::to_string(parent.id) + " as a parent: must have " + *demand};
  if (!vacancy.successor || parent.species == *vacancy.successor) return;
  throw RuleError{"parent", "individual " + std::to_string(parent.id) + ", a " + web.name(parent.species) +
                                ", as the parent of a " + web.name(*vacancy.successor) + ": must be of its offspring's species"};
}

/// Throws RuleError unless a body that a slot's rule named exists and has an individual.
inline void check_lives(std::string_view slot, std::string_view what, BodyIndex body, std::span<const Individual> robots) {
  check_index(slot, what, body, robots.size());
  if (robots[body].lives()) return;
  throw RuleError{slot, std::string{what} + " " + std::to_string(body) + ": must be a body with an individual"};
}

/// The same for all bodies that a rule of death returned.
inline void check_captures(std::span<const death::Capture> captures, std::span<const Individual> robots) {
  for (const death::Capture& capture : captures) {
    check_lives("capture", "hunter", capture.hunter, robots);
    check_lives("capture", "victim", capture.victim, robots);
  }
}
inline void check_starving(const death::Starving& starving, std::span<const Individual> robots) {
  for (const BodyIndex hunter : starving.exempt) check_lives("starvation", "exempt hunter", hunter, robots);
  for (const BodyIndex victim : starving.victims) check_lives("starvation", "victim", victim, robots);
}
inline void check_sacrifices(std::span<const death::Sacrifice> sacrifices, std::span<const Individual> robots) {
  for (const death::Sacrifice& sacrifice : sacrifices) check_lives("minimum_predators", "victim", sacrifice.victim, robots);
}

/// Throws std::invalid_argument unless a saved individual has one of the tags, perceives one of the bodies and, if it lives,
/// `is_of_rules`; a spare body must have nothing but a tag.
inline void check_saved(const Individual& one, std::span<const int> tags, bool is_of_rules, std::size_t bodies) {
  const bool has_tag = std::ranges::count(tags, one.tag) == 1;
  const bool is_spare = one.id == no_individual && !one.genome && !one.active && !one.adversary;
  if (!one.lives()) return Archive::require(is_spare && has_tag, "a spare body from different rules");
  Archive::require(is_of_rules && has_tag && one.adversary.value_or(0) < bodies, "an individual from different rules");
}

/// Throws std::invalid_argument unless a checkpoint has a finite position for each robot.
inline void check_saved_poses(std::span<const GroundPose> poses, std::size_t robots) {
  Archive::require(poses.size() == robots, "a different number of robots");
  for (const GroundPose& pose : poses) {
    const bool is_somewhere = std::abs(pose.x_m) < 1e9 && std::abs(pose.y_m) < 1e9 && std::isfinite(pose.heading_rad);
    Archive::require(is_somewhere, "a robot without a finite position");
  }
}

/// Returns the number of bodies that start without an individual. Throws RuleError unless it is below the number of robots.
[[nodiscard]] inline std::size_t checked_spare_bodies(std::size_t spare, std::size_t robots) {
  if (spare < robots) return spare;
  throw RuleError{"recruitment",
                  "spare_bodies = " + std::to_string(spare) + ": must be < " + std::to_string(robots) + ", the number of robots"};
}

/// Throws RuleError unless a birth without a death has an endowment >= 0, a place in the arena, if any, and parents of the
/// newborn's species whose genomes violate no demand: `demand_of(parent)` returns it (Population::misfit).
template <class DemandOf>
void check_recruit(const FoodWeb& web, const Arena& arena, const reproduction::Recruit& recruit, const DemandOf& demand_of) {
  check_index("recruitment", "species", recruit.species, web.size());
  if (!(recruit.endowment_J >= 0.0 && std::isfinite(recruit.endowment_J)))
    throw RuleError{"recruitment", "endowment_J = " + number_text(recruit.endowment_J) + ": must be >= 0 and finite"};
  for (const Ancestor& parent : recruit.parents) {
    const std::string who = "individual " + std::to_string(parent.id) + " as a parent: must ";
    if (parent.species != recruit.species) throw RuleError{"recruitment", who + "be of the newborn's species"};
    if (const std::optional<std::string> demand = demand_of(parent)) throw RuleError{"recruitment", who + "have " + *demand};
  }
  if (!recruit.place) return;
  const GroundPose& at = *recruit.place;
  const bool is_inside = std::abs(at.x_m) <= arena.half_side_m && std::abs(at.y_m) <= arena.half_side_m;
  if (is_inside && std::isfinite(at.heading_rad)) return;
  throw RuleError{"recruitment", "a birth at (" + number_text(at.x_m) + ", " + number_text(at.y_m) +
                                     "): must be finite and within +-" + number_text(arena.half_side_m) + " m"};
}

/// Throws RuleError for a species' name that would break a row of a table: with a comma, a quote or a control character.
inline void check_names(const FoodWeb& web) {
  for (Species species = 0; species < web.size(); ++species) {
    const std::string& name = web.name(species);
    if (is_plain(name) && name.find_first_of(",\"") == std::string::npos) continue;
    throw RuleError{"community", "the name of species " + std::to_string(species) + ", \"" + name +
                                     "\": must have no comma, quote or control character"};
  }
}

/// Throws RuleError unless a slot's rule returned one value for each robot.
inline void check_one_each(std::string_view slot, std::string_view what, std::size_t returned, std::size_t robots) {
  if (returned == robots) return;
  throw RuleError{slot, std::to_string(returned) + " " + std::string{what} + ": must be " + std::to_string(robots) +
                            ", the number of robots"};
}

/// Throws RuleError unless there is a finite place for each robot.
inline void check_places(std::span<const GroundPose> places, std::size_t robots) {
  check_one_each("placement", "places", places.size(), robots);
  for (std::size_t body = 0; body < places.size(); ++body) {
    const GroundPose& place = places[body];
    if (std::isfinite(place.x_m) && std::isfinite(place.y_m) && std::isfinite(place.heading_rad)) continue;
    throw RuleError{"placement", "the place of body " + std::to_string(body) + ": must be finite"};
  }
}

}  // namespace trophic::detail
