// SPDX-License-Identifier: MIT
// The rule table of the study: the race's pond with more senses and a brain that grows.
#pragma once

#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/perception/sensors/food_gradient.hpp>
#include <trophic/perception/sensors/own_energy.hpp>
#include <trophic/perception/sensors/own_speed.hpp>
#include <trophic/worlds/pond_race.hpp>

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

}  // namespace trophic::open_ended
