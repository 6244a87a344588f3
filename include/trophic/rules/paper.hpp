// SPDX-License-Identifier: MIT
// The rules as the paper states them.
#pragma once

#include <trophic/backend/contract.hpp>
#include <trophic/control/brain/cognitive_brain.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/death/activation/active_away_from_hunters.hpp>
#include <trophic/death/capture/catch_within_reach.hpp>
#include <trophic/death/floor/victim_floor.hpp>
#include <trophic/death/minimum_predators/sacrifice_random_victim.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt.hpp>
#include <trophic/death/starvation/exemption/near_perceived_victim.hpp>
#include <trophic/death/starvation/interval/delayed_crowding_interval.hpp>
#include <trophic/death/starvation/procedure.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/initialization/community/predator_prey.hpp>
#include <trophic/initialization/placement/scattered.hpp>
#include <trophic/perception/heading/forward_axis_heading.hpp>
#include <trophic/perception/newborn_tag/keeps_body_tag.hpp>
#include <trophic/perception/sensors/distance_over_terrain.hpp>
#include <trophic/perception/sensors/list.hpp>
#include <trophic/perception/sensors/side_of_adversary.hpp>
#include <trophic/perception/sensors/tag_ratio_of_all.hpp>
#include <trophic/perception/tag_switch/tag_cool_down.hpp>
#include <trophic/perception/visibility/same_tag.hpp>
#include <trophic/reproduction/genome_source/random_or_inherited.hpp>
#include <trophic/reproduction/heredity/own_copy.hpp>
#include <trophic/reproduction/initial_genome/uniform_weights.hpp>
#include <trophic/reproduction/mutation/normal_mutation.hpp>
#include <trophic/reproduction/parent/by_cause.hpp>
#include <trophic/reproduction/parent/killer.hpp>
#include <trophic/reproduction/parent/nearest_active_victim.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/rules/with_part.hpp>

namespace trophic::rules {

/// Kachler and Miras, "Open-endedness induced through a predator-prey scenario using modular robots": the rule in each slot,
/// the section of the paper from which it comes, and every number. The paper has no natural death, so the slot Senescence is
/// omitted. "silent" marks choices that the text leaves open. The policy explains each such choice;
/// studies/results/open-choices.md lists all of them with their alternatives and effects.
///
/// One choice reverses the evolution of prey: the choice of the parent when a predator starves. Sec. "Reproduction" has "any
/// prey". Sec. "Prey Death" calls the newborn's state "a state of inactivity", and a draft's comment in Sec. "Birth" denies that
/// a newborn "can immediately interact with other robots". So the table uses the closest active prey; `with_parent_after<Paper,
/// Cause::starved, NearestVictim>` is the alternative reading.
///
/// The robot's own gait is the one published with the paper. The text would also allow a gait evolved with its fitness function
/// (`spider_paper`). The paper's robots walked with the published one, which is faster and turns equally to both sides
/// (models/README.md has the figures).
struct Paper final {
  static constexpr std::string_view name = "paper";

  // Sec. "Initialization"
  using Community = initialization::community::PredatorPrey;
  using Placement = initialization::placement::Scattered;  // silent

  // Sec. "Tagging System"
  using Visibility = perception::visibility::SameTag;        // silent: of an inactive robot
  using TagSwitch = perception::tag_switch::TagCoolDown;     // silent: whether it runs at birth
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;  // silent

  // Sec. "Cognitive Brain": "Inputs", "Outputs"
  using Sensors = perception::sensors::List<perception::sensors::SideOfAdversary, perception::sensors::DistanceOverTerrain,
                                            perception::sensors::TagRatioOfAll>;
  using Brain = control::brain::CognitiveBrain;  // silent: hidden neurons, biases

  // Sec. "Targeted Steering"
  using Heading = perception::heading::ForwardAxisHeading;  // silent: of a tilted robot
  using Steering = control::steering::TargetedSteering;

  // Sec. "Birth": "Initialization", "Reproduction"
  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using GenomeSource = reproduction::genome_source::RandomOrInherited;                      // silent: without a parent
  using Parent = reproduction::parent::ByCause<reproduction::parent::Killer,                // of a caught prey
                                               reproduction::parent::NearestActiveVictim>;  // starved; silent: activity,
                                                                                            // and on sacrificed prey
  using Heredity = reproduction::heredity::OwnCopy;
  using Mutation = reproduction::mutation::NormalMutation;

  // Sec. "Prey Death"
  using Activation = death::activation::ActiveAwayFromHunters;  // silent: founders
  using Capture = death::capture::CatchWithinReach;
  using Floor = death::floor::VictimFloor;  // silent: whether inactive prey count
  using MinimumPredators = death::minimum_predators::SacrificeRandomVictim;

  // Sec. "Predator Death"
  using Starvation = death::starvation::Procedure<death::starvation::interval::DelayedCrowdingInterval,
                                                  death::starvation::exemption::NearPerceivedVictim,
                                                  death::starvation::choice::HungriestNonexempt>;  // "the next oldest"

  static TableParams<Paper> params() {
    return TableParams<Paper>{
        .community = {.predators = 14},
        .newborn_tag = {.founder_tag = 1},  // silent: released code
        .tag_switch = {.cool_down_s = 50.0},
        .brain = {.turn_angle_rad = 0.7},
        .steering = {.exponent = 2.0},
        .initial_genome = {.limit = 1.0},
        .genome_source = {.random_share = 1.0 / 3.0},
        .parent = {.starved = {.range_m = 12.0}},  // silent: inherited genomes come near the text's baseline of 2/3
        .mutation = {.sd = 0.05},                  // silent: width of the released code's
        .activation = {.distance_m = 5.0},         // silent: released code
        .capture = {.reach_m = 1.0, .min_age_s = 0.0},
        .floor = {.floor = 7},
        .starvation = {.interval = {.base_ticks = 25, .min_interval_ticks = 2, .only_above = 0},
                       .exemption = {.range_m = 5.0}},  // silent: released code
        .minimum_predators = {.below = 7},
    };
  }

  // Sec. "Robot Body and Environment", "Cognitive Brain", "Birth", "Outputs"
  static EcologyParams ecology() {
    return {.robots = 30,
            .duration_s = 6000.0,
            .tick_s = 2.0,
            .first_tick_s = 0.0,
            .control_hz = 60.0,
            .clock_scale = 1.0,
            .robot = "spider",
            .arena = "walled_square",
            .gait = {},
            .cpg_integration = CpgIntegration::exact,
            .idle_control_steps = 0,
            .phase_at_birth = PhaseAtBirth::kept,       // silent: released code
            .decision_order = DecisionOrder::together,  // silent
            .without_target = WithoutTarget::decides};  // silent
  }
  static Physics physics() { return {.timestep_s = 0.0012, .integrator = Integrator::semi_implicit_euler, .gravity_m_s2 = 9.81}; }
};

}  // namespace trophic::rules
