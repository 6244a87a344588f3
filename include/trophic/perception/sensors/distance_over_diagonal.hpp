// SPDX-License-Identifier: MIT
// The paper's Distance input, read as a fraction of the arena's diagonal.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: min(1, distance / (sqrt(2) * largest terrain extent)); 1 without an adversary. The paper is silent: "divided by the
/// maximum terrain bounds" (Sec. "Inputs") may mean the side or the diagonal, the longest distance that the arena allows.
/// DistanceOverTerrain divides by the side.   Reads: distance, arena.   Random draws: 0.
struct DistanceOverDiagonal {
  static constexpr std::string_view name = "distance_over_diagonal";
  static constexpr std::string_view source = "paper: silent; a reading of Sec. \"Inputs\"";
  static constexpr std::size_t size = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>& sighting, const View& view, Rng&) const {
    return {sighting ? std::min(1.0, sighting->distance_m / (std::numbers::sqrt2 * view.arena.extent_m)) : 1.0};
  }
};
static_assert(OwnSensor<DistanceOverDiagonal>);

}  // namespace trophic::perception::sensors
