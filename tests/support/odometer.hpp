// SPDX-License-Identifier: MIT
// A sensor with a State, for tests.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::test {

/// How far a robot has walked in its life, metres. It does not care whom it sees.
struct Odometer {
  static constexpr std::string_view name = "odometer";
  static constexpr std::size_t size = 1;
  struct State {
    double walked_m = 0.0;
    static constexpr auto fields() { return std::tuple{field("walked_m", &State::walked_m)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_walk(State& own, BodyIndex, double distance_m, const View&) const { own.walked_m += distance_m; }
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>&, const View&, Rng&,
                                               const State& own) const {
    return {own.walked_m};
  }
};

}  // namespace trophic::test
