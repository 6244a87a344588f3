// SPDX-License-Identifier: MIT
// More senses and neurons than the paper's robots have: room for evolution.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <trophic/control/brain/cognitive_brain.hpp>
#include <trophic/params/params.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/perception/sensors/list.hpp>
#include <trophic/perception/sensors/side_of_adversary.hpp>
#include <trophic/perception/sensors/tag_ratio_of_all.hpp>

namespace trophic::arms_race {

/// Rule: how far the adversary is within each of three distances s: max(0, 1 - distance / s); 0 without an adversary. So a brain
/// distinguishes near from far without a threshold of its own.   Reads: distance.   Random draws: 0.
struct DistanceBands {
  static constexpr std::string_view name = "distance_bands";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 3;
  static constexpr std::array<double, size> bands_m{2.0, 5.0, 15.0};
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>& sighting, const View&, Rng&) const {
    std::array<double, size> values{};
    for (std::size_t i = 0; i < size && sighting; ++i) values[i] = std::max(0.0, 1.0 - sighting->distance_m / bands_m[i]);
    return values;
  }
};

/// Rule: the closeness c = max(0, 1 - distance / 3 m) of the nearest wall, and its direction as c cos b, c sin b for its bearing
/// b.   Reads: own pose, arena.   Random draws: 0.
struct NearestWall {
  static constexpr std::string_view name = "nearest_wall";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 2;
  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    const GroundPose& pose = view.poses[self];
    const bool is_in_x = std::abs(pose.x_m) > std::abs(pose.y_m);
    const double along_m = is_in_x ? pose.x_m : pose.y_m;
    const double toward_rad = (is_in_x ? 0.0 : 0.5 * std::numbers::pi) + (along_m < 0.0 ? std::numbers::pi : 0.0);
    const double closeness = std::max(0.0, 1.0 - (view.arena.half_side_m - std::abs(along_m)) / 3.0);
    const double bearing_rad = toward_rad - pose.heading_rad;
    return {closeness * std::cos(bearing_rad), closeness * std::sin(bearing_rad)};
  }
};

/// Rule: the distance walked in the last tick over 0.2 m, at most 1; a robot that is stuck has 0.   Reads: its own state.
/// Random draws: 0.
struct OwnSpeed {
  static constexpr std::string_view name = "own_speed";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 1;
  struct State {
    double walked_m = 0.0;
    static constexpr auto fields() { return std::tuple{field("walked_m", &State::walked_m)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_walk(State& own, BodyIndex, double distance_m, const View&) const { own.walked_m = distance_m; }
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>&, const View&, Rng&,
                                               const State& own) const {
    return {std::min(1.0, own.walked_m / 0.2)};
  }
};

/// Rule: the tag that the robot shows.   Reads: own tag.   Random draws: 0.
struct OwnTag {
  static constexpr std::string_view name = "own_tag";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 1;
  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    return {static_cast<double>(view.robots[self].tag)};
  }
};

/// Nine inputs instead of the paper's three.
using RoomySensors = perception::sensors::List<perception::sensors::SideOfAdversary, DistanceBands,
                                               perception::sensors::TagRatioOfAll, NearestWall, OwnSpeed, OwnTag>;

/// Rule: as CognitiveBrain with eight hidden neurons and biases: 98 weights for nine inputs instead of 15 for three. Target angle
/// +0.7 rad if out[0] > 0, else -0.7 rad; tag +1 if out[1] > 0, else -1.   Random draws: 0.
struct RoomyBrain : control::brain::CognitiveBrain {
  static constexpr std::string_view name = "roomy_brain";
  static constexpr std::string_view source = "not in the paper";
  using Network = control::TanhNetwork<8, control::Biases::both_layers>;
  using WithBiases = RoomyBrain;

  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t outputs) const {
    return Network::weights_size(inputs, outputs);
  }
  [[nodiscard]] std::vector<std::size_t> neurons(std::size_t inputs, std::size_t outputs) const {
    return control::neurons_of<Network::bias>({inputs}, 8, outputs);
  }
  void evaluate(std::span<const double> inputs, std::span<const double> weights, std::span<double> outputs) const {
    Network::evaluate(inputs, weights, outputs);
  }
};
static_assert(control::Brain<RoomyBrain>);

/// A table with these senses and this brain.
template <class Base>
using WithRoom = with_brain<with_sensors<Base, RoomySensors>, RoomyBrain>;

}  // namespace trophic::arms_race
