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
                                               params.recruitment = {.spare_bodies = 90, .birth_J = 80.0, .share = 0.5};
                                               params.resource = {
                                                   .capacity_J_m2 = 15.0, .growth_1_s = 0.006, .seed_1_s = 0.002, .season = 0.0};
                                               params.metabolism.template get<0>() = {
                                                   .first_J = 30.0, .resting_W = 0.05, .walking_J_per_m = 1.0, .bite_W = 0.4};
                                               params.metabolism.template get<1>() = {.first_J = 30.0,
                                                                                      .capacity_J = 300.0,
                                                                                      .resting_W = 0.05,
                                                                                      .walking_J_per_m = 1.0,
                                                                                      .efficiency = 0.3};
                                               params.community.predators = 12;
                                             }>,
                                 [](EcologyParams& ecology) {
                                   ecology.robots = 150;
                                   ecology.arena = "refuges";
                                 }>,
                    "hide_and_seek">;

}  // namespace hide_and_seek
