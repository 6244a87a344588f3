// SPDX-License-Identifier: MIT
// A rule table written out.
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
  using NewbornTag = P::NewbornTag;
  using TagSwitch = P::TagSwitch;
  using Brain = P::Brain;
  using Steering = P::Steering;
  using InitialGenome = P::InitialGenome;
  using GenomeSource = P::GenomeSource;
  using Parent = P::Parent;
  using Heredity = P::Heredity;
  using Mutation = P::Mutation;
  using Activation = P::Activation;
  using Capture = P::Capture;
  using Floor = P::Floor;
  using Starvation = P::Starvation;
  using MinimumPredators = P::MinimumPredators;
  static trophic::TableParams<Table> params() { return trophic::TableParams<Table>{.floor = {.floor = 5}}; }
  static trophic::EcologyParams ecology() { return {}; }
  static trophic::Physics physics() { return {}; }
};

int main() {
  trophic::Ecology<Table> ecology({.seed = 1}, trophic::backend::Kinematic::Params{});
  ecology.run_until(10.0);
}
