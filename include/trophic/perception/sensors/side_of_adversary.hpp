// SPDX-License-Identifier: MIT
// The paper's Angle input: the side of the adversary.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: -1 if the adversary is on the left, +1 if it is on the right (Sec. "Inputs"); straight ahead counts as right,
/// straight behind as left. Without an adversary it is 0, neither side; the paper is silent.   Reads: bearing.   Random draws: 0.
struct SideOfAdversary {
  static constexpr std::string_view name = "side_of_adversary";
  static constexpr std::string_view source = "paper, Sec. \"Inputs\"";
  static constexpr std::size_t size = 1;
  static constexpr double least = -1.0;
  static constexpr double most = 1.0;
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>& sighting, const View&, Rng&) const {
    if (!sighting) return {0.0};
    return {sighting->bearing_rad < 0.0 ? -1.0 : 1.0};
  }
};
static_assert(OwnSensor<SideOfAdversary>);

}  // namespace trophic::perception::sensors
