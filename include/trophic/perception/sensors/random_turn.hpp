// SPDX-License-Identifier: MIT
// A random number for brains that make robots walk at random.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: the difference of two uniform numbers, in (-1, 1) with mean 0, new at each tick: NetLogo's "right random, left random"
/// [wilensky1997].   Reads: nothing.   Random draws: 2.
struct RandomTurn {
  static constexpr std::string_view name = "random_turn";
  static constexpr std::string_view source = "not in the paper; [wilensky1997]";
  static constexpr std::size_t size = 1;
  static constexpr double least = -1.0;
  static constexpr double most = 1.0;
  [[nodiscard]] std::array<double, size> sense(BodyIndex, const std::optional<Sighting>&, const View&, Rng& rng) const {
    return {rng.uniform() - rng.uniform()};
  }
};
static_assert(OwnSensor<RandomTurn>);

}  // namespace trophic::perception::sensors
