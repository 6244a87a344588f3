// SPDX-License-Identifier: MIT
// The messages of a page to a live run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tools/live/live_server.hpp>

namespace trophic::live {

/// Largest message of a page, bytes.
inline constexpr std::size_t most_wish_bytes = 4096;
/// Bounds of a speed other than 0, "as fast as it goes": ecology seconds a second.
inline constexpr double least_speed = 0.05;
inline constexpr double most_speed = 1000.0;

/// A wish of a page about a run.
struct Wish {
  enum class Kind { play, pause, tick, speed, set, restart };
  Kind kind = Kind::pause;
  double speed = 0.0;
  std::string number = {};  ///< its path
  std::string value = {};   ///< as --set reads it
  std::uint64_t seed = 0;
  std::string rule_table = {};
};

/// Reads a message: {"do": "play"}, "pause" or "tick"; {"do": "speed", "value": 10}; {"do": "set", "number": PATH, "value":
/// "0.5"}; {"do": "restart", "seed": 7, "rules": NAME}. Throws std::invalid_argument, in one sentence, for anything else, as for
/// parameters and rule tables that the run does not have.
[[nodiscard]] Wish read_wish(std::string_view message, const command::LiveRun& run);

}  // namespace trophic::live
