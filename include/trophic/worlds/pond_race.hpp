// SPDX-License-Identifier: MIT
// A pond in which both species inherit their walking pace.
#pragma once

#include <trophic/control/pace/inherited_pace.hpp>
#include <trophic/reproduction/heredity/switched.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/worlds/pond.hpp>

namespace trophic::worlds {

using HeritablePace = reproduction::traits::List<control::pace::WalkingPace>;
inline constexpr auto on_four_times_the_floor = [](auto& params) {
  params.community.predators = 48;
  params.recruitment.spare_bodies = 360;
  params.resource.cells_in_a_row = 40;
  params.metabolism.template get<1>().efficiency = 0.15;
};
inline constexpr auto with_600_robots = [](EcologyParams& ecology) {
  ecology.robots = 600;
  ecology.arena = "walled_pond";
};

/// Rules: like Pond, with four times its bodies and floor, and each individual walks at the WalkingPace that it inherits.
/// A predator gets 0.15 of the energy of its prey, as those of Pond that walk faster and faster eat their prey up.
/// Each metre costs what it costs in Pond, so a faster individual spends more. One species may inherit against another that does
/// not (`rules.heredity.prey.inherited`).   Source: not in the literature as such.
using PondRace =
    named<with_ecology<
              with_params<with_heredity<with_pace<with_traits<Pond, HeritablePace>, control::pace::InheritedPace<HeritablePace>>,
                                        rules::by_species<reproduction::heredity::Switched<Pond::Heredity>>>,
                          on_four_times_the_floor>,
              with_600_robots>,
          "pond_race">;

}  // namespace trophic::worlds
