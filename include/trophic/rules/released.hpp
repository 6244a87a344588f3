// SPDX-License-Identifier: MIT
// The rules as the paper's released code plays them.
#pragma once

#include <string_view>
#include <trophic/control/brain/cognitive_brain_zero_right.hpp>
#include <trophic/control/decision_order/decide_in_turn.hpp>
#include <trophic/death/capture/catch_closest.hpp>
#include <trophic/death/reprieve/near_remembered_adversary.hpp>
#include <trophic/perception/blind_rule/blind_keeps_decision.hpp>
#include <trophic/perception/heading/root_yaw_heading.hpp>
#include <trophic/perception/sensors/distance_over_scale.hpp>
#include <trophic/perception/sensors/side_away_from_hunter.hpp>
#include <trophic/perception/sensors/tag_ratio_of_active.hpp>
#include <trophic/perception/tag_switch/tag_sampling.hpp>
#include <trophic/placement/uniform_square.hpp>
#include <trophic/reproduction/heredity/shared_copy.hpp>
#include <trophic/reproduction/mutation/uniform_mutation.hpp>
#include <trophic/reproduction/parent/last_killer.hpp>
#include <trophic/reproduction/parent/last_seen_victim.hpp>
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

  using Heading = perception::heading::RootYawHeading;
  using Visibility = perception::visibility::SameTag;
  using Sensors = perception::sensors::List<perception::sensors::SideAwayFromHunter, perception::sensors::DistanceOverScale,
                                            perception::sensors::TagRatioOfActive>;
  using BlindRule = perception::blind_rule::BlindKeepsDecision;
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;
  using TagSwitch = perception::tag_switch::TagSampling;
  using Brain = control::brain::CognitiveBrainZeroRight;
  using DecisionOrder = control::decision_order::DecideInTurn;
  using Steering = control::steering::TargetedSteering;

  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using GenomeSource = reproduction::genome_source::RandomOrInherited;
  static constexpr GenomeSource::Params genome_source{.random_share = 0.34, .orphans_labelled_inherited = true};
  using CaptureParent = reproduction::parent::Killer;
  using StarvationParent = reproduction::parent::LastSeenVictim;
  using RescueParent = reproduction::parent::LastKiller;
  using Heredity = reproduction::heredity::SharedCopy;
  using Mutation = reproduction::mutation::UniformMutation;

  using Activation = death::activation::ActiveAwayFromHunters;
  static constexpr Activation::Params activation{.restarts_age = true};
  using Capture = death::capture::CatchClosest;
  using Floor = death::floor::VictimFloor;
  static constexpr Floor::Params floor{.floor = 6};
  using StarvationSchedule = death::starvation_schedule::CrowdingInterval;
  static constexpr StarvationSchedule::Params starvation_schedule{.only_above = 7, .reevaluated = true};
  using Reprieve = death::reprieve::NearRememberedAdversary;
  using Starvation = death::starvation::HungriestStarves;
  static constexpr Starvation::Params starvation{.even_if_all_spared = true};
  using Rescue = death::rescue::SacrificeRandomVictim;
  static constexpr Rescue::Params rescue{.below = 8};
  using Senescence = death::senescence::NoSenescence;
  using SenescenceParent = reproduction::parent::NoParent;

  /// All timers of the released code ran on the wall clock, about 1.2 simulated seconds per second. The gait is the published
  /// one, the robot's own, as in `Paper`.
  static World world() {
    return {.duration_s = 6500.0,
            .first_tick_s = 2.0,
            .clock_scale = 1.2,
            .robot = "spider_released",
            .arena = "height_field",
            .gait = {},
            .cpg_integration = locomotion::CpgIntegration::rk4};
  }
  static Physics physics() { return {.timestep_s = 0.012, .integrator = Integrator::rk4}; }
};

}  // namespace trophic::rules
