// SPDX-License-Identifier: MIT
// A table in which hunted species age.
#pragma once

#include <trophic/death/senescence/old_age_of_victims.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/rules/with_part.hpp>

namespace trophic {

/// The table in which hunted species die at a given age, with a parent for the newborn that follows: the nearest individual of
/// the species, or that of a different parent rule, `with_ageing_victims<Paper, MostEscapes>`. The table's Parent must be a
/// ByCause.
template <class Rules, class Parent = reproduction::parent::NearestConspecific>
using with_ageing_victims =
    with_parent_after<with_senescence<Rules, death::senescence::OldAgeOfVictims>, Cause::senescence, Parent>;

}  // namespace trophic
