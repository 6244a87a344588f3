// SPDX-License-Identifier: MIT
// The rules of the paper's released code.
#pragma once

#include <numbers>
#include <trophic/control/brain/cognitive_brain_zero_right.hpp>
#include <trophic/death/activation/ages_once_away_from_hunters.hpp>
#include <trophic/death/capture/catch_closest.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt_else_hungriest.hpp>
#include <trophic/death/starvation/exemption/near_remembered_adversary.hpp>
#include <trophic/death/starvation/interval/direct_crowding_interval.hpp>
#include <trophic/initialization/placement/uniform_square.hpp>
#include <trophic/perception/heading/root_yaw_heading.hpp>
#include <trophic/perception/sensors/distance_over_scale.hpp>
#include <trophic/perception/sensors/side_away_from_hunter.hpp>
#include <trophic/perception/sensors/tag_ratio_of_active.hpp>
#include <trophic/perception/tag_switch/tag_sampling.hpp>
#include <trophic/reproduction/genome_source/random_or_inherited_in_name.hpp>
#include <trophic/reproduction/heredity/shared_copy.hpp>
#include <trophic/reproduction/mutation/uniform_mutation.hpp>
#include <trophic/reproduction/parent/last_killer.hpp>
#include <trophic/reproduction/parent/last_seen_victim.hpp>
#include <trophic/rules/paper.hpp>

namespace trophic::rules {

/// The released code, rule by rule, as read from the code at the commits of the published runs (22 and 23 June 2023).
/// studies/ablations lists the slots and parameters in which it differs from the text.
///
/// Not reproduced:
/// - ticks of 2.007 s on average, with wall time between the actions within a tick: a wall clock cannot be reproduced;
/// - control calls on the grid of the physics, 12 or 24 ms apart, while the CPG always integrates 1/60 s: same mean rate;
/// - the genome's five biases, which mutate but are never added and so have no effect;
/// - an activated newborn's age counts from the tick before; no rule reads the age of prey.
/// Its analysis: published velocities include adversaries stored while a robot perceived none (metric velocity_stored).
struct Released final {
  static constexpr std::string_view name = "released";

  using Community = initialization::community::PredatorPrey;
  using Placement = initialization::placement::UniformSquare;

  using Visibility = perception::visibility::SameTag;
  using TagSwitch = perception::tag_switch::TagSampling;
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;

  using Sensors = perception::sensors::List<perception::sensors::SideAwayFromHunter, perception::sensors::DistanceOverScale,
                                            perception::sensors::TagRatioOfActive>;
  using Brain = control::brain::CognitiveBrainZeroRight;

  using Heading = perception::heading::RootYawHeading;
  using Steering = control::steering::TargetedSteering;

  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using GenomeSource = reproduction::genome_source::RandomOrInheritedInName;
  using Parent = reproduction::parent::ByCause<reproduction::parent::Killer,          // of a caught prey
                                               reproduction::parent::LastSeenVictim,  // of a starved predator
                                               reproduction::parent::LastKiller>;     // of a sacrificed prey
  using Heredity = reproduction::heredity::SharedCopy;
  using Mutation = reproduction::mutation::UniformMutation;

  using Activation = death::activation::AgesOnceAwayFromHunters;
  using Capture = death::capture::CatchClosest;
  using Floor = death::floor::VictimFloor;
  using MinimumPredators = death::minimum_predators::SacrificeRandomVictim;

  using Starvation = death::starvation::Procedure<death::starvation::interval::DirectCrowdingInterval,
                                                  death::starvation::exemption::NearRememberedAdversary,
                                                  death::starvation::choice::HungriestNonexemptElseHungriest>;

  static TableParams<Released> params() {
    return TableParams<Released>{
        .community = {.predators = 14},
        .placement = {.half_extent_m = 9.0, .heading_rad = -0.75 * std::numbers::pi},
        .sensors = Sensors::with<perception::sensors::DistanceOverScale>({.full_scale_m = 20.0}),
        .newborn_tag = {.founder_tag = 1},
        .tag_switch = {.period_s = 100.0},
        .brain = {.turn_angle_rad = 0.7},
        .steering = {.exponent = 2.0},
        .initial_genome = {.limit = 1.0},
        .genome_source = {.random_share = 0.34},
        .mutation = {.half_width = 0.05, .limit = 1.0},
        .activation = {.distance_m = 5.0},
        .capture = {.reach_m = 1.0, .min_age_s = 20.0},
        .floor = {.floor = 6},
        .starvation = {.interval = {.base_ticks = 25, .min_interval_ticks = 2, .only_above = 7}, .exemption = {.range_m = 5.0}},
        .minimum_predators = {.below = 8},
    };
  }

  /// All timers of the released code ran on the wall clock, about 1.2 simulated seconds per second. The gait is the published
  /// one, the robot's own, as in `Paper`. Control starts after one control period.
  static EcologyParams ecology() {
    return {.robots = 30,
            .duration_s = 6500.0,
            .tick_s = 2.0,
            .first_tick_s = 2.0,
            .control_hz = 60.0,
            .clock_scale = 1.2,
            .robot = "spider_released",
            .arena = "height_field",
            .gait = {},
            .cpg_integration = CpgIntegration::rk4,
            .idle_control_steps = 1,
            .phase_at_birth = PhaseAtBirth::kept,
            .decision_order = DecisionOrder::in_turn,
            .without_target = WithoutTarget::keeps_decision};
  }
  static Physics physics() { return {.timestep_s = 0.012, .integrator = Integrator::rk4, .gravity_m_s2 = 9.81}; }
};

}  // namespace trophic::rules
