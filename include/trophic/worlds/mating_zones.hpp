// SPDX-License-Identifier: MIT
// Robots of one species that mate in zones, and live on what they were born with.
#pragma once

#include <array>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/energy/metabolism/falling_energy.hpp>
#include <trophic/energy/resource/moving_zones.hpp>
#include <trophic/perception/sensors/nearest_zone.hpp>
#include <trophic/reproduction/heredity/crossover.hpp>
#include <trophic/reproduction/recruitment/in_zones.hpp>
#include <trophic/rules/paper.hpp>

namespace trophic::worlds {

namespace mating_zones {

/// One species, which hunts none.
struct Community {
  static constexpr std::string_view name = "one_species";
  static constexpr std::array<std::string_view, 1> species_names{"robot"};
  [[nodiscard]] FoodWeb web() const { return {{"robot"}, {}}; }
  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const { return std::vector<Species>(robots); }
};
static_assert(initialization::Community<Community>);

}  // namespace mating_zones

/// Rules: 30 founders on a square of 25 m have 100 J each and lose 5 a minute (FallingEnergy). At the end of each minute those in
/// a zone of 2 m mate in pairs; each parent gives 25 J, the newborn starts with 100 J at 3 m from a parent (InZones), and the
/// zone moves (MovingZones). A run ends at 0 or at 100 robots. Newborns that have only what their parents gave:
/// `rules.metabolism.newborn_J=0`. Finite food, 300 a minute for all: `rules.resource.food_W=5`. Brains steer by the nearest zone
/// and inherit weights from both parents.   Source: Sec. 4.6 of [peterson2026], on the backend `torus`; other backends have walls
/// instead of its torus. Its robots are geckos with HyperNEAT, which have to learn to walk, and steer by an assigned zone. Units:
/// J, m, s.
struct MatingZones final {
  static constexpr std::string_view name = "mating_zones";

  using Community = mating_zones::Community;
  using Placement = initialization::placement::Scattered;
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;
  using Sensors = perception::sensors::List<perception::sensors::NearestZone>;
  using Acts = control::acts::List<control::acts::Turn>;
  using Brain = control::brain::FeedForwardBrain;
  using Heading = perception::heading::ForwardAxisHeading;
  using Steering = control::steering::TargetedSteering;

  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using Heredity = reproduction::heredity::Crossover;
  using Mutation = reproduction::mutation::NormalMutation;
  using Recruitment = reproduction::recruitment::InZones;
  using Resource = energy::resource::MovingZones;
  using Metabolism = energy::metabolism::FallingEnergy;

  static TableParams<MatingZones> params() {
    return {.mutation = {.sd = 0.1},
            .recruitment = {.spare_bodies = 70, .interval_ticks = 30, .offspring = 1, .cost_J = 25.0, .step_m = 3.0}};
  }
  static EcologyParams ecology() {
    EcologyParams own = rules::Paper::ecology();
    own.robots = 100;
    own.arena = "square_25";
    own.ends_when = EndsWhen::gone_or_no_spare;
    return own;
  }
  static Physics physics() { return rules::Paper::physics(); }
};

}  // namespace trophic::worlds
