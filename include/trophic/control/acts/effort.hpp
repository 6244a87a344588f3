// SPDX-License-Identifier: MIT
// How hard a robot walks.
#pragma once

#include <trophic/control/acts/contract.hpp>

namespace trophic::control::acts {

/// Rule: factor of the gait's frequency, on a backend of points of speed and turning rate: 0 stands, 1 walks as without this act.
/// For an output in (-1, 1) it is (1 + output) / 2.   Reads: its output.   Random draws: 0.
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
