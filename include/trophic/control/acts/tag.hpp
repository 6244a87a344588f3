// SPDX-License-Identifier: MIT
// The paper's second output: the tag.
#pragma once

#include <limits>
#include <trophic/control/acts/contract.hpp>

namespace trophic::control::acts {

/// Rule: the tag that the brain chooses (Sec. "Outputs"): +1 if the output is positive, else -1, unless the brain has its own
/// `int tag(double output) const`. The rule TagSwitch decides whether the robot shows it; other rules read the shown tag.
/// Reads: its output.   Random draws: 0.
struct Tag {
  static constexpr std::string_view name = "tag";
  static constexpr std::string_view source = "paper, Sec. \"Outputs\"";
  static constexpr std::string_view unit{};
  static constexpr std::size_t outputs = 1;
  static constexpr double least = std::numeric_limits<int>::min();
  static constexpr double most = std::numeric_limits<int>::max();
  static constexpr int by_default = 0;
  [[nodiscard]] static int value(std::span<const double, outputs> out) { return out[0] > 0.0 ? 1 : -1; }
  [[nodiscard]] static int of(const Individual& self) { return self.tag; }
};
static_assert(Act<Tag>);

}  // namespace trophic::control::acts
