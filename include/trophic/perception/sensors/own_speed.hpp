// SPDX-License-Identifier: MIT
// The speed of the robot itself.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: the straight distance walked in the last tick, per second and divided by full_scale, at most 1; a robot that is stuck
/// has 0. The scale is a free parameter.   Reads: its own state.   Random draws: 0.
struct OwnSpeed {
  static constexpr std::string_view name = "own_speed";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;

  struct Params {
    double full_scale_m_s = 0.1;
    static constexpr auto fields() {
      return std::tuple{field("full_scale_m_s", &Params::full_scale_m_s, above(0.0), "speed at which the input reaches 1")};
    }
  };
  Params params;

  struct State {
    double walked_m = 0.0;
    static constexpr auto fields() { return std::tuple{field("walked_m", &State::walked_m)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_walk(State& own, BodyIndex, double distance_m, const View&) const { own.walked_m = distance_m; }

  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>&, const View& view, Rng&,
                                               const State& own) const {
    return {std::min(1.0, own.walked_m / view.tick_s / params.full_scale_m_s)};
  }
};
static_assert(OwnSensor<OwnSpeed>);

}  // namespace trophic::perception::sensors
