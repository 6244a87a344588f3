// SPDX-License-Identifier: MIT
// The paper's Distance input: a fraction of the terrain.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: min(1, distance / largest terrain extent) (Sec. "Inputs": "divided by the maximum terrain bounds"). The paper is
/// silent about distances beyond one side, which a diagonal allows: they are clipped to 1, because all inputs lie in [-1, 1].
/// Without an adversary the value is 1, the farthest; the paper is silent. DistanceOverDiagonal divides by the diagonal.   Reads:
/// distance, arena.   Random draws: 0.
struct DistanceOverTerrain {
  static constexpr std::string_view name = "distance_over_terrain";
  static constexpr std::string_view source = "paper, Sec. \"Inputs\"";
  static constexpr std::size_t size = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>& sighting, const View& view, Rng&) const {
    return {sighting ? std::min(1.0, sighting->distance_m / view.arena.extent_m) : 1.0};
  }
};
static_assert(OwnSensor<DistanceOverTerrain>);

}  // namespace trophic::perception::sensors
