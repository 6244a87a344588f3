// SPDX-License-Identifier: MIT
// The paper's table with its open choices as parameters.
#pragma once

#include <trophic/death/activation/founders_start_active.hpp>
#include <trophic/death/floor/active_victim_floor.hpp>
#include <trophic/death/starvation/choice/hungriest_else_oldest.hpp>
#include <trophic/initialization/placement/uniform_square.hpp>
#include <trophic/perception/newborn_tag/random_tag.hpp>
#include <trophic/perception/sensors/distance_over_diagonal.hpp>
#include <trophic/perception/sensors/tag_ratio_of_active.hpp>
#include <trophic/perception/visibility/same_tag_if_active.hpp>
#include <trophic/reproduction/genome_source/random_or_inherited_in_name.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/reproduction/parent/no_parent.hpp>
#include <trophic/rules/paper.hpp>

#include "any_heading.hpp"
#include "any_tag_switch.hpp"
#include "either.hpp"

namespace trophic::readings {

/// `Paper`, but each slot that the text leaves open holds the table's policy as its first reading and another as its second.
/// With first readings everywhere a run is that of `Paper`, to the byte.
struct PaperReadings final {
  static constexpr std::string_view name = "paper_readings";
  using Paper = rules::Paper;

  using Community = Paper::Community;
  using Placement = Either<Paper::Placement, initialization::placement::UniformSquare>;

  using Visibility = Either<Paper::Visibility, perception::visibility::SameTagIfActive>;
  using TagSwitch = AnyTagSwitch;
  using NewbornTag = Either<Paper::NewbornTag, perception::newborn_tag::RandomTag>;

  using Distance = EitherSensor<perception::sensors::DistanceOverTerrain, perception::sensors::DistanceOverDiagonal>;
  using TagRatio = EitherSensor<perception::sensors::TagRatioOfAll, perception::sensors::TagRatioOfActive>;
  using Sensors = perception::sensors::List<perception::sensors::SideOfAdversary, Distance, TagRatio>;
  using Brain = Either<Paper::Brain, Paper::Brain::WithBiases>;

  using Heading = AnyHeading;
  using Steering = Paper::Steering;

  using InitialGenome = Paper::InitialGenome;
  using GenomeSource = Either<Paper::GenomeSource, reproduction::genome_source::RandomOrInheritedInName>;
  template <Cause cause>
  using PaperParent = Paper::Parent::Part<static_cast<std::size_t>(cause)>;
  using Parent = reproduction::parent::ByCause<PaperParent<Cause::caught>,
                                               Either<PaperParent<Cause::starved>, reproduction::parent::NearestVictim>,
                                               Either<PaperParent<Cause::sacrificed>, reproduction::parent::NearestConspecific>>;
  using Heredity = Paper::Heredity;
  using Mutation = Paper::Mutation;

  using Activation = Either<Paper::Activation, death::activation::FoundersStartActive>;
  using Capture = Paper::Capture;
  using Floor = Either<Paper::Floor, death::floor::ActiveVictimFloor>;
  using MinimumPredators = Paper::MinimumPredators;

  using Starvation =
      death::starvation::Procedure<Paper::Starvation::Part<0>, Paper::Starvation::Part<1>,
                                   Either<Paper::Starvation::Part<2>, death::starvation::choice::HungriestElseOldest>>;

  static TableParams<PaperReadings> params() {
    const TableParams<Paper> paper = Paper::params();
    return TableParams<PaperReadings>{
        .community = paper.community,
        .newborn_tag = {.first = paper.newborn_tag},
        .tag_switch = {.cool_down_s = paper.tag_switch.cool_down_s},
        .brain = {.first = paper.brain, .second = {.turn_angle_rad = paper.brain.turn_angle_rad}},
        .steering = paper.steering,
        .initial_genome = paper.initial_genome,
        .genome_source = {.first = paper.genome_source, .second = paper.genome_source},
        .parent = {.starved = {.first = paper.parent.starved, .second = {.range_m = paper.parent.starved.range_m}}},
        .mutation = paper.mutation,
        .activation = {.first = paper.activation, .second = paper.activation},
        .capture = paper.capture,
        .floor = {.first = paper.floor, .second = {.floor = paper.floor.floor}},
        .starvation = {.interval = paper.starvation.interval, .exemption = paper.starvation.exemption},
        .minimum_predators = paper.minimum_predators,
    };
  }
  static EcologyParams ecology() { return Paper::ecology(); }
  static Physics physics() { return Paper::physics(); }
};

}  // namespace trophic::readings
