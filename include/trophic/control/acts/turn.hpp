// SPDX-License-Identifier: MIT
// The paper's first output: the target angle.
#pragma once

#include <numbers>
#include <trophic/control/acts/contract.hpp>

namespace trophic::control::acts {

/// Rule: the target angle, positive to the right (Sec. "Outputs"). Brains with `double target_angle_rad(double output) const`
/// convert the output by their own rule, such as the paper's two angles; for other brains it is the output in radians.   Reads:
/// its output.   Random draws: 0.
struct Turn {
  static constexpr std::string_view name = "turn";
  static constexpr std::string_view source = "paper, Sec. \"Outputs\"";
  static constexpr std::string_view unit = "rad";
  static constexpr std::size_t outputs = 1;
  static constexpr double least = -std::numbers::pi;
  static constexpr double most = std::numbers::pi;
  static constexpr double by_default = 0.0;
  [[nodiscard]] static double value(std::span<const double, outputs> out) { return std::clamp(out[0], least, most); }
  [[nodiscard]] static double of(const Individual& self) { return self.target_angle_rad; }
};
static_assert(Act<Turn>);

}  // namespace trophic::control::acts
