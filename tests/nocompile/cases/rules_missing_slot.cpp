// SPDX-License-Identifier: MIT
// A table that leaves out a rule has no experiment to run.
// expect: the rule table has no slot Mutation; write `using Mutation = ...;`
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Table final {
  static constexpr std::string_view name = "table";
  using P = trophic::rules::Paper;
  using Community = P::Community;
  using Placement = P::Placement;
  using Heading = P::Heading;
  using Visibility = P::Visibility;
  using Sensors = P::Sensors;
  using BlindRule = P::BlindRule;
  using NewbornTag = P::NewbornTag;
  using TagSwitch = P::TagSwitch;
  using Brain = P::Brain;
  using DecisionOrder = P::DecisionOrder;
  using Steering = P::Steering;
  using InitialGenome = P::InitialGenome;
  using GenomeSource = P::GenomeSource;
  using CaptureParent = P::CaptureParent;
  using StarvationParent = P::StarvationParent;
  using RescueParent = P::RescueParent;
  using Heredity = P::Heredity;
#ifdef VALID
  using Mutation = P::Mutation;
#endif
  using Activation = P::Activation;
  using Capture = P::Capture;
  using Floor = P::Floor;
  using StarvationSchedule = P::StarvationSchedule;
  using Reprieve = P::Reprieve;
  using Starvation = P::Starvation;
  using Rescue = P::Rescue;
  using Senescence = P::Senescence;
  using SenescenceParent = P::SenescenceParent;
  static trophic::TableParams<Table> params() {
    return trophic::TableParams<Table>{.floor = {.floor = 5}};
  }
  static trophic::EcologyParams ecology() {
    return {};
  }
  static trophic::Physics physics() {
    return {};
  }
};

int main() {
  trophic::Ecology<Table> ecology({.seed = 1}, trophic::backend::Kinematic::Params{});
  ecology.run_until(10.0);
}
