// SPDX-License-Identifier: MIT
// How hard a robot walks.
#pragma once

#include <trophic/control/acts/contract.hpp>

namespace trophic::control::acts {

/// Rule: a factor applied to the gait's frequency or, on a backend of points, to speed and turning rate: at 0 the robot stands
/// still, at 1 it walks as without this act. For an output in (-1, 1) the factor is (1 + output) / 2.   Reads: its output. Random
/// draws: 0.
struct Effort {
  static constexpr std::string_view name = "effort";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::string_view unit{};
  static constexpr std::size_t outputs = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  static constexpr double by_default = 1.0;
  [[nodiscard]] static double value(std::span<const double, outputs> out) {
    return std::clamp(0.5 * (1.0 + out[0]), least, most);
  }
};
static_assert(Act<Effort>);

}  // namespace trophic::control::acts
