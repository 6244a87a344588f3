// SPDX-License-Identifier: MIT
// A pond of one's own in 40 lines: eyes, refuges, and predators that are faster than prey.
#pragma once

#include <trophic/trophic.hpp>

namespace hide_and_seek {

using namespace trophic;
using perception::sensors::Rays;
using perception::sensors::Sees;

using Senses = perception::sensors::PerSpecies<
    perception::sensors::List<Rays<8, Sees::hunters, Sees::walls, Sees::food>, perception::sensors::OwnEnergy>,
    perception::sensors::List<Rays<5, Sees::victims, Sees::walls>>>;
using Sensing = with_sensors<rules::Paper, Senses>;
using Thinking = with_brain<Sensing, rules::by_species<control::brain::FeedForwardBrain>>;
using Acting = with_acts<Thinking, control::acts::List<control::acts::Turn, control::acts::Tag, control::acts::Effort>>;
using Paced = with_pace<Acting, rules::by_species<control::pace::ConstantPace>>;
using Hiding = with_capture<Paced, death::capture::CatchOutsideRefuges>;
using Growing = with_resource<Hiding, energy::resource::LogisticField>;
using Eating = with_metabolism<Growing, rules::by_species<energy::metabolism::GrazingAndHunting>>;
using Bearing = with_recruitment<Eating, reproduction::recruitment::AtEnergy>;
using Dying = with_minimum_predators<with_floor<with_starvation<Bearing, death::starvation::NoStarvation>, death::floor::NoFloor>,
                                     death::minimum_predators::NoMinimum>;
using Table = named<with_ecology<with_params<Dying,
                                             [](auto& params) {
                                               params.pace.template get<1>().factor = 1.3;
                                               params.sensors.template get<1>().template get<0>().field_rad = 1.6;
                                               params.recruitment = {.spare_bodies = 40, .birth_J = 80.0, .share = 0.5};
                                               params.metabolism.template get<1>().bite_W = 0.0;
                                               params.community.predators = 8;
                                             }>,
                                 [](EcologyParams& ecology) {
                                   ecology.robots = 80;
                                   ecology.arena = "refuges";
                                 }>,
                    "hide_and_seek">;

}  // namespace hide_and_seek
