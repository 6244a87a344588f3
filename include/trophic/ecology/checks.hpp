// SPDX-License-Identifier: MIT
// Rejects invalid return values of rules: too few founders or places, catches of species that the hunter does not eat, unfit
// parents.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <trophic/death/capture/contract.hpp>
#include <trophic/death/minimum_predators/contract.hpp>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/recruitment/contract.hpp>
#include <trophic/support/linkage.hpp>
#include <trophic/support/units.hpp>

namespace trophic::detail {

/// Throws RuleError unless the hunter's species eats the victim's.
void check_prey(const FoodWeb& web, BodyIndex hunter, Species eater, BodyIndex victim, Species eaten);

/// Throws RuleError if the rules fix a body's new species and the parent is of another one, or if the parent's genome violates
/// `demand` (Population::misfit).
void check_parent(const FoodWeb& web, const reproduction::Vacancy& vacancy, const Ancestor& parent,
                  const std::optional<std::string>& demand);

/// Throws RuleError unless a body that a slot's rule named exists and has an individual.
void check_lives(std::string_view slot, std::string_view what, BodyIndex body, std::span<const Individual> robots);

/// The same of all bodies that a rule of death returned.
void check_captures(std::span<const death::Capture> captures, std::span<const Individual> robots);
void check_starving(const death::Starving& starving, std::span<const Individual> robots);
void check_sacrifices(std::span<const death::Sacrifice> sacrifices, std::span<const Individual> robots);

/// Throws std::invalid_argument unless a checkpoint has a finite position for each robot.
void check_saved_poses(std::span<const GroundPose> poses, std::size_t robots);

/// Returns the number of bodies that start without an individual. Throws RuleError unless it is below the number of robots.
[[nodiscard]] std::size_t checked_spare_bodies(std::size_t spare, std::size_t robots);

/// Throws RuleError unless the body of a birth without a death is spare and the parent, if any, is of the newborn's species and
/// has a genome that violates no `demand` (Population::misfit).
void check_recruit(const FoodWeb& web, const reproduction::Recruit& recruit, std::span<const Individual> robots,
                   const std::optional<std::string>& demand);

/// Throws RuleError for a species' name that would break a row of a table: with a comma, a quote or a control character.
void check_names(const FoodWeb& web);

/// Throws RuleError unless a slot's rule returned one value for each robot.
void check_one_each(std::string_view slot, std::string_view what, std::size_t returned, std::size_t robots);

/// Throws RuleError unless there is a finite place for each robot.
void check_places(std::span<const GroundPose> places, std::size_t robots);

}  // namespace trophic::detail

#if TROPHIC_HEADER_ONLY
#include <trophic/ecology/checks.ipp>
#endif
