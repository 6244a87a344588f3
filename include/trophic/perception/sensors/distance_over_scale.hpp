// SPDX-License-Identifier: MIT
// The released code's Distance input: a fraction of a fixed length.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: min(1, distance / full_scale) with full_scale 20 m for any arena (released code); 1 without an adversary.   Reads:
/// distance.   Random draws: 0.
struct DistanceOverScale {
  static constexpr std::string_view name = "distance_over_scale";
  static constexpr std::string_view source = "released code";
  static constexpr std::size_t size = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;

  struct Params {
    double full_scale_m = 20.0;
    static constexpr auto fields() {
      return std::tuple{field("full_scale_m", &Params::full_scale_m, above(0.0), "distance at which the input reaches 1")};
    }
  };
  Params params;

  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>& sighting, const View&, Rng&) const {
    return {sighting ? std::min(1.0, sighting->distance_m / params.full_scale_m) : 1.0};
  }
};
static_assert(OwnSensor<DistanceOverScale>);

}  // namespace trophic::perception::sensors
