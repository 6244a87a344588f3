// SPDX-License-Identifier: MIT
// A pond: prey graze, predators hunt, living costs energy, and population sizes change.
#pragma once

#include <trophic/energy/metabolism/grazing_and_hunting.hpp>
#include <trophic/energy/resource/logistic_field.hpp>
#include <trophic/reproduction/genome_source/always_inherited.hpp>
#include <trophic/reproduction/recruitment/at_energy.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>

namespace trophic::worlds {

/// Rules: prey graze a field that regrows (LogisticField), and predators take the energy of the prey that they catch. Both spend
/// energy on living and walking, and starve without energy (GrazingAndHunting). An individual with `birth_J` shares its energy
/// with an offspring next to it (AtEnergy). Bodies, senses, brains, tags and activation are those of Paper. No floor, sacrifice
/// or newcomer maintains a species, so either may die out. Births depend on two conditions, energy and activity. A newborn prey
/// is inactive, safe and infertile until it has been farther than 4 m from every predator, which is a condition on behaviour.
/// `only_active` of Recruitment and `distance_m` of Activation remove it.   Source: not in the paper; the energy balance follows
/// Polyworld [yaeger1994]. All parameters are free.   Units: J, m, s.
struct Pond final {
  static constexpr std::string_view name = "pond";

  using Community = initialization::community::PredatorPrey;
  using Placement = initialization::placement::Scattered;

  using Visibility = perception::visibility::SameTag;
  using TagSwitch = perception::tag_switch::TagCoolDown;
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;
  using Sensors = rules::Paper::Sensors;
  using Brain = control::brain::CognitiveBrain;
  using Heading = perception::heading::ForwardAxisHeading;
  using Steering = control::steering::TargetedSteering;

  using Resource = energy::resource::LogisticField;
  using Metabolism = rules::by_species<energy::metabolism::GrazingAndHunting>;
  using Recruitment = reproduction::recruitment::AtEnergy;

  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using GenomeSource = reproduction::genome_source::AlwaysInherited;
  using Heredity = reproduction::heredity::OwnCopy;
  using Mutation = reproduction::mutation::NormalMutation;

  using Activation = death::activation::ActiveAwayFromHunters;
  using Capture = death::capture::CatchWithinReach;

  static TableParams<Pond> params() {
    TableParams<Pond> own{
        .community = {.predators = 12},
        .tag_switch = {.cool_down_s = 50.0},
        .recruitment = {.spare_bodies = 90, .birth_J = 80.0, .share = 0.5},
        .activation = {.distance_m = 4.0},
        .capture = {.reach_m = 0.7, .min_age_s = 20.0},
        .resource = {.cells_in_a_row = 20, .capacity_J_m2 = 15.0, .growth_1_s = 0.006, .seed_1_s = 0.002, .season = 0.0}};
    own.metabolism.get<0>() = {.first_J = 30.0, .capacity_J = 200.0, .resting_W = 0.05, .walking_J_per_m = 1.0, .bite_W = 0.4};
    own.metabolism.get<1>() = {
        .first_J = 30.0, .capacity_J = 300.0, .resting_W = 0.05, .walking_J_per_m = 1.0, .bite_W = 0.0, .efficiency = 0.3};
    return own;
  }
  static EcologyParams ecology() {
    EcologyParams own = rules::Paper::ecology();
    own.robots = 150;
    return own;
  }
  static Physics physics() { return rules::Paper::physics(); }
};

}  // namespace trophic::worlds
