// SPDX-License-Identifier: MIT
// The rules as the paper states them.
#pragma once

#include <string_view>
#include <trophic/backend/contract.hpp>
#include <trophic/community/predator_prey.hpp>
#include <trophic/control/brain/cognitive_brain.hpp>
#include <trophic/control/decision_order/decide_together.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/death/activation/active_away_from_hunters.hpp>
#include <trophic/death/capture/catch_within_reach.hpp>
#include <trophic/death/floor/victim_floor.hpp>
#include <trophic/death/reprieve/near_perceived_victim.hpp>
#include <trophic/death/rescue/sacrifice_random_victim.hpp>
#include <trophic/death/senescence/no_senescence.hpp>
#include <trophic/death/starvation/hungriest_starves.hpp>
#include <trophic/death/starvation_schedule/crowding_interval.hpp>
#include <trophic/ecology/world.hpp>
#include <trophic/perception/blind_rule/blind_decides.hpp>
#include <trophic/perception/heading/forward_axis_heading.hpp>
#include <trophic/perception/newborn_tag/keeps_body_tag.hpp>
#include <trophic/perception/sensors/distance_over_terrain.hpp>
#include <trophic/perception/sensors/list.hpp>
#include <trophic/perception/sensors/side_of_adversary.hpp>
#include <trophic/perception/sensors/tag_ratio_of_all.hpp>
#include <trophic/perception/tag_switch/tag_cool_down.hpp>
#include <trophic/perception/visibility/same_tag.hpp>
#include <trophic/placement/scattered.hpp>
#include <trophic/reproduction/genome_source/random_or_inherited.hpp>
#include <trophic/reproduction/heredity/own_copy.hpp>
#include <trophic/reproduction/initial_genome/uniform_weights.hpp>
#include <trophic/reproduction/mutation/normal_mutation.hpp>
#include <trophic/reproduction/parent/killer.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/reproduction/parent/no_parent.hpp>
#include <trophic/rules/table.hpp>

namespace trophic::rules {

/// Kachler and Miras, "Open-endedness induced through a predator-prey scenario using modular robots". Every number is the
/// policies' default; what the paper is silent about is said in each policy.
///
/// The robot's own gait is the one published with the paper. Its text would allow another one evolved by its fitness
/// (`spider_paper`); the published one is what the paper's robots walked with, it is faster, and it turns to both sides alike
/// (models/README.md has the figures).
struct Paper {
  static constexpr std::string_view name = "paper";

  using Community = community::PredatorPrey;
  using Placement = placement::Scattered;

  using Heading = perception::heading::ForwardAxisHeading;
  using Visibility = perception::visibility::SameTag;
  using Sensors = perception::sensors::List<perception::sensors::SideOfAdversary, perception::sensors::DistanceOverTerrain,
                                            perception::sensors::TagRatioOfAll>;
  using BlindRule = perception::blind_rule::BlindDecides;
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;
  using TagSwitch = perception::tag_switch::TagCoolDown;
  using Brain = control::brain::CognitiveBrain;
  using DecisionOrder = control::decision_order::DecideTogether;
  using Steering = control::steering::TargetedSteering;

  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using GenomeSource = reproduction::genome_source::RandomOrInherited;
  using CaptureParent = reproduction::parent::Killer;
  using StarvationParent = reproduction::parent::NearestVictim;
  using RescueParent = reproduction::parent::NoParent;
  using Heredity = reproduction::heredity::OwnCopy;
  using Mutation = reproduction::mutation::NormalMutation;

  using Activation = death::activation::ActiveAwayFromHunters;
  using Capture = death::capture::CatchWithinReach;
  using Floor = death::floor::VictimFloor;
  using StarvationSchedule = death::starvation_schedule::CrowdingInterval;
  using Reprieve = death::reprieve::NearPerceivedVictim;
  using Starvation = death::starvation::HungriestStarves;
  using Rescue = death::rescue::SacrificeRandomVictim;
  using Senescence = death::senescence::NoSenescence;
  using SenescenceParent = reproduction::parent::NoParent;

  static World world() { return {}; }
  static Physics physics() { return {}; }
};

}  // namespace trophic::rules
