// SPDX-License-Identifier: MIT
// What rules must not return: catches of nobody's prey, parents of another species than their offspring.
#pragma once

#include <trophic/population/food_web.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::detail {

/// Throws RuleError unless the hunter's species eats the victim's.
void check_prey(const FoodWeb& web, BodyIndex hunter, Species eater, BodyIndex victim, Species eaten);

/// A body goes to the species that the rules fix; throws RuleError for a parent of another one.
void check_parent(const FoodWeb& web, const reproduction::Vacancy& vacancy, const Ancestor& parent);

}  // namespace trophic::detail

#if TROPHIC_HEADER_ONLY
#include <trophic/ecology/checks.ipp>
#endif
