// SPDX-License-Identifier: MIT
// Wolves, sheep and grass as a project of one's own has them: 25 lines, for the backend `torus`.
#include <trophic/experiment.hpp>
#include <trophic/trophic.hpp>

#include "hide_and_seek.hpp"

using namespace trophic;

struct Meadow final {
  static constexpr std::string_view name = "meadow";
  using Community = initialization::community::PredatorPrey;
  using Placement = initialization::placement::Scattered;
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;
  using Sensors = perception::sensors::List<perception::sensors::RandomTurn>;
  using Brain = control::brain::TurnsByInput;
  using Heading = perception::heading::ForwardAxisHeading;
  using Steering = control::steering::TargetedSteering;
  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using Heredity = reproduction::heredity::OwnCopy;
  using Capture = death::capture::OneWithinReach;
  using Resource = energy::resource::DelayedPatches;
  using Metabolism = rules::by_species<energy::metabolism::FixedGains>;
  using Recruitment = rules::by_species<reproduction::recruitment::ByChance>;
  static TableParams<Meadow> params() {
    TableParams<Meadow> own{.community = {.predators = 50}, .capture = {.reach_m = 0.56}};
    own.metabolism.get<1>().gain_J = 20.0;
    own.recruitment.get<0>() = {.spare_bodies = 1850, .chance = 0.04};
    return own;
  }
  static EcologyParams ecology() { return {.robots = 2000, .tick_s = 1.0, .control_hz = 1.0, .arena = "square_51", .gait = {}}; }
  static Physics physics() { return {}; }
};

int main(int argc, char** argv) {
  return experiment<Meadow, hide_and_seek::Table>(argc, argv);
}
