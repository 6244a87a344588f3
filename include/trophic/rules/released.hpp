// SPDX-License-Identifier: MIT
// The rules as the paper's released code plays them.
#pragma once

#include <string_view>
#include <trophic/control/decide_in_turn.hpp>
#include <trophic/death/catch_closest.hpp>
#include <trophic/death/near_remembered_adversary.hpp>
#include <trophic/perception/blind_keeps_outputs.hpp>
#include <trophic/perception/distance_over_scale.hpp>
#include <trophic/perception/root_yaw_heading.hpp>
#include <trophic/perception/side_away_from_hunter.hpp>
#include <trophic/perception/tag_ratio_of_active.hpp>
#include <trophic/perception/tag_sampling.hpp>
#include <trophic/placement/uniform_square.hpp>
#include <trophic/reproduction/last_killer.hpp>
#include <trophic/reproduction/last_seen_victim.hpp>
#include <trophic/reproduction/shared_copy.hpp>
#include <trophic/reproduction/uniform_mutation.hpp>
#include <trophic/rules/paper.hpp>

namespace trophic::rules {

/// What the released code does where it differs from the text, rule by rule; the alias of a rule that does not differ, or only in
/// numbers, is that of `Paper`. Read off the code at the commits of the published runs (22 and 23 June 2023).
///
/// Not done:
/// - ticks of 2.007 s on average, with what happens within a tick taking wall time: a wall clock cannot be reproduced;
/// - control calls on the grid of the physics, 12 or 24 ms apart, while the CPG always integrates 1/60 s: same mean rate;
/// - the genome's five biases, which mutate and are never added: they have no effect;
/// - an activated newborn's age counts from the tick before; no rule reads the age of prey.
/// Of its analysis: published velocities include adversaries stored while a robot was blind (metric velocity_stored).
struct Released {
  static constexpr std::string_view name = "released";

  using Community = community::PredatorPrey;
  using Placement = placement::UniformSquare;

  using Heading = perception::RootYawHeading;
  using Visibility = perception::SameTag;
  using AngleInput = perception::SideAwayFromHunter;
  using DistanceInput = perception::DistanceOverScale;
  using TagRatioInput = perception::TagRatioOfActive;
  using BlindRule = perception::BlindKeepsOutputs;
  using NewbornTag = perception::KeepsBodyTag;
  using TagSwitch = perception::TagSampling;
  using Brain = control::CognitiveBrain;
  static constexpr Brain::Params brain{.zero_turns_right = true};
  using DecisionOrder = control::DecideInTurn;
  using Steering = control::TargetedSteering;

  using InitialGenome = reproduction::UniformWeights;
  using GenomeSource = reproduction::RandomOrInherited;
  static constexpr GenomeSource::Params genome_source{.random_share = 0.34, .orphans_labelled_inherited = true};
  using CaptureParent = reproduction::Killer;
  using StarvationParent = reproduction::LastSeenVictim;
  using RescueParent = reproduction::LastKiller;
  using Heredity = reproduction::SharedCopy;
  using Mutation = reproduction::UniformMutation;

  using Activation = death::ActiveAwayFromHunters;
  static constexpr Activation::Params activation{.restarts_age = true};
  using Capture = death::CatchClosest;
  using Floor = death::VictimFloor;
  static constexpr Floor::Params floor{.floor = 6};
  using StarvationSchedule = death::CrowdingInterval;
  static constexpr StarvationSchedule::Params starvation_schedule{.only_above = 7, .reevaluated = true};
  using Reprieve = death::NearRememberedAdversary;
  using Starvation = death::HungriestStarves;
  static constexpr Starvation::Params starvation{.even_if_all_spared = true};
  using Rescue = death::SacrificeRandomVictim;
  static constexpr Rescue::Params rescue{.below = 8};
  using Senescence = death::NoSenescence;
  using SenescenceParent = reproduction::NoParent;

  /// All timers of the released code ran on the wall clock, about 1.2 simulated seconds per second. The gait is the published
  /// one, the robot's own, as in `Paper`.
  static World world() {
    return {.duration_s = 6500.0,
            .first_tick_s = 2.0,
            .clock_scale = 1.2,
            .robot = "spider_released",
            .arena = "height_field",
            .gait = {},
            .cpg_integration = control::CpgIntegration::rk4};
  }
  static Physics physics() { return {.timestep_s = 0.012, .integrator = Integrator::rk4}; }
};

}  // namespace trophic::rules
