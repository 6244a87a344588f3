// SPDX-License-Identifier: MIT
// Hunger: the energy of the robot itself.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: own energy / full_scale, clipped to [0, 1]. The scale is a free parameter.   Reads: own energy.   Random draws: 0.
struct OwnEnergy {
  static constexpr std::string_view name = "own_energy";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;

  struct Params {
    double full_scale_J = 100.0;
    static constexpr auto fields() {
      return std::tuple{field("full_scale_J", &Params::full_scale_J, above(0.0), "energy at which the input reaches 1")};
    }
  };
  Params params;

  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    return {std::clamp(view.robots[self].energy_J / params.full_scale_J, 0.0, 1.0)};
  }
};
static_assert(OwnSensor<OwnEnergy>);

}  // namespace trophic::perception::sensors
