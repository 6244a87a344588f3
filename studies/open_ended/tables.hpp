// SPDX-License-Identifier: MIT
// The rule tables of the study: the race's pond with more senses and a brain that grows, with one food and with two.
#pragma once

#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/perception/sensors/food_gradient.hpp>
#include <trophic/perception/sensors/own_energy.hpp>
#include <trophic/perception/sensors/own_speed.hpp>
#include <trophic/worlds/pond_race.hpp>
#include <trophic/worlds/two_foods.hpp>

namespace trophic::open_ended {

/// The paper's three inputs, and smell, hunger and speed: seven.
using Senses = perception::sensors::List<perception::sensors::SideOfAdversary, perception::sensors::DistanceOverTerrain,
                                         perception::sensors::TagRatioOfAll, perception::sensors::FoodGradient,
                                         perception::sensors::OwnEnergy, perception::sensors::OwnSpeed>;

/// Brains start without hidden neurons and change often, so that they can grow within a run. A neuron that goes takes its links
/// along, so links are added more often than removed.
inline constexpr auto from_no_neurons = [](auto& params) {
  params.brain.hidden = 0;
  params.brain.add_link = 0.5;
  params.brain.remove_link = 0.3;
  params.brain.split_link = params.brain.remove_neuron = 0.2;
};

/// Rules: like PondRace, with these senses and GrowingBrain. The limits of brain and body are `rules.brain.most_hidden` and
/// `rules.traits.walking_pace.most`.   Source: not in the literature as such; limits and space after [channon2019].
using GrowingRace =
    named<with_params<with_brain<with_sensors<worlds::PondRace, Senses>, control::brain::GrowingBrain>, from_no_neurons>,
          "growing_race">;

using PaceAndDiet = reproduction::traits::List<control::pace::WalkingPace, energy::metabolism::Diet>;
inline constexpr auto with_two_foods_on_four_times_the_floor = [](auto& params) {
  worlds::with_two_foods(params);
  params.resource.template get<0>().cells_in_a_row = params.resource.template get<1>().cells_in_a_row = 40;
  params.metabolism.template get<1>().energy.efficiency = 0.15;
};

/// Rules: like GrowingRace, with the two foods of TwoFoods, of which each prey inherits its Diet too. Each food grows as the one
/// of GrowingRace.   Source: not in the literature as such.
using GrowingRaceTwoFoods =
    named<with_params<with_pace<with_traits<with_metabolism<with_resource<GrowingRace, worlds::GrassAndFruit>,
                                                            rules::by_species<energy::metabolism::GrazingByDiet<PaceAndDiet>>>,
                                            PaceAndDiet>,
                                control::pace::InheritedPace<PaceAndDiet>>,
                      with_two_foods_on_four_times_the_floor>,
          "growing_race_two_foods">;

}  // namespace trophic::open_ended
