// SPDX-License-Identifier: MIT
// A sound signal of a robot.
#pragma once

#include <trophic/control/acts/contract.hpp>

namespace trophic::control::acts {

/// Rule: the loudness of a signal on a channel is the output, clipped to [0, 1], so a negative output is silence.
/// sensors::Hearing perceives it at the next tick.   Reads: its output.   Random draws: 0.
template <std::size_t channel>
struct Signal {
  static_assert(channel < 10, "acts::Signal has the channels 0 to 9");
  static constexpr std::array<char, 8> letters{'s', 'i', 'g', 'n', 'a', 'l', '_', static_cast<char>('0' + channel)};
  static constexpr std::string_view name{letters.data(), letters.size()};
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::string_view unit{};
  static constexpr std::size_t outputs = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  static constexpr double by_default = 0.0;
  [[nodiscard]] static double value(std::span<const double, outputs> out) { return std::clamp(out[0], least, most); }
};
static_assert(Act<Signal<0>>);

}  // namespace trophic::control::acts
