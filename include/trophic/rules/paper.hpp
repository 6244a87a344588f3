// SPDX-License-Identifier: MIT
// The rules as the paper states them.
#pragma once

#include <string_view>
#include <trophic/backend/concept.hpp>
#include <trophic/community/predator_prey.hpp>
#include <trophic/control/cognitive_brain.hpp>
#include <trophic/control/decide_together.hpp>
#include <trophic/control/targeted_steering.hpp>
#include <trophic/death/active_away_from_hunters.hpp>
#include <trophic/death/catch_within_reach.hpp>
#include <trophic/death/crowding_interval.hpp>
#include <trophic/death/hungriest_starves.hpp>
#include <trophic/death/near_perceived_victim.hpp>
#include <trophic/death/no_senescence.hpp>
#include <trophic/death/sacrifice_random_victim.hpp>
#include <trophic/death/victim_floor.hpp>
#include <trophic/perception/blind_sees_nothing.hpp>
#include <trophic/perception/distance_over_terrain.hpp>
#include <trophic/perception/forward_axis_heading.hpp>
#include <trophic/perception/keeps_body_tag.hpp>
#include <trophic/perception/same_tag.hpp>
#include <trophic/perception/side_of_adversary.hpp>
#include <trophic/perception/tag_cool_down.hpp>
#include <trophic/perception/tag_ratio_of_all.hpp>
#include <trophic/placement/scattered.hpp>
#include <trophic/reproduction/killer.hpp>
#include <trophic/reproduction/nearest_victim.hpp>
#include <trophic/reproduction/no_parent.hpp>
#include <trophic/reproduction/normal_mutation.hpp>
#include <trophic/reproduction/own_copy.hpp>
#include <trophic/reproduction/random_or_inherited.hpp>
#include <trophic/reproduction/uniform_weights.hpp>
#include <trophic/rules.hpp>
#include <trophic/world.hpp>

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

  using Heading = perception::ForwardAxisHeading;
  using Visibility = perception::SameTag;
  using AngleInput = perception::SideOfAdversary;
  using DistanceInput = perception::DistanceOverTerrain;
  using TagRatioInput = perception::TagRatioOfAll;
  using BlindRule = perception::BlindSeesNothing;
  using NewbornTag = perception::KeepsBodyTag;
  using TagSwitch = perception::TagCoolDown;
  using Brain = control::CognitiveBrain;
  using DecisionOrder = control::DecideTogether;
  using Steering = control::TargetedSteering;

  using InitialGenome = reproduction::UniformWeights;
  using GenomeSource = reproduction::RandomOrInherited;
  using CaptureParent = reproduction::Killer;
  using StarvationParent = reproduction::NearestVictim;
  using RescueParent = reproduction::NoParent;
  using Heredity = reproduction::OwnCopy;
  using Mutation = reproduction::NormalMutation;

  using Activation = death::ActiveAwayFromHunters;
  using Capture = death::CatchWithinReach;
  using Floor = death::VictimFloor;
  using StarvationSchedule = death::CrowdingInterval;
  using Reprieve = death::NearPerceivedVictim;
  using Starvation = death::HungriestStarves;
  using Rescue = death::SacrificeRandomVictim;
  using Senescence = death::NoSenescence;
  using SenescenceParent = reproduction::NoParent;

  static World world() { return {}; }
  static Physics physics() { return {}; }
};

}  // namespace trophic::rules
