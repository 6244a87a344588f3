// SPDX-License-Identifier: MIT
// A brain without genes that turns in proportion to its input.
#pragma once

#include <trophic/control/brain/contract.hpp>

namespace trophic::control::brain {

/// Rule: target angle = turn * input, tag 1. With the sensor RandomTurn the robot walks at random; if the turn is a full circle,
/// the next heading is uniform.   Reads: the only input.   Random draws: 0.
struct TurnsByInput {
  static constexpr std::string_view name = "turns_by_input";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t inputs = 1;

  struct Params {
    double turn_rad = 0.5;
    static constexpr auto fields() {
      return std::tuple{
          field("turn_rad", &Params::turn_rad, between(0.0, 2.0 * std::numbers::pi), "target angle for an input of 1")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t genome_size(std::size_t, std::size_t) const { return 0; }
  [[nodiscard]] std::vector<int> tags() const { return {1}; }
  [[nodiscard]] Decision decide(std::span<const double> input, std::span<const double>) const {
    return {.target_angle_rad = params.turn_rad * input[0], .tag = 1};
  }
};
static_assert(Brain<TurnsByInput>);

}  // namespace trophic::control::brain
