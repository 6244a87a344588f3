// SPDX-License-Identifier: MIT
// A world before its run, by which a rule can state that its parameters leave it idle.
#pragma once

#include <cstddef>
#include <numbers>
#include <string>
#include <trophic/habitat/arena.hpp>
#include <trophic/population/food_web.hpp>
#include <vector>

namespace trophic {

/// A rule of any slot may have `std::string idle(const Outset& outset) const`: it returns a sentence if the rule can never act in
/// this world by its parameters, and "" otherwise. The program prints the sentence before the run, and the manifest has it among
/// its remarks.
struct Outset {
  const FoodWeb& web;
  const Arena& arena;
  std::size_t robots = 0;                  ///< bodies
  std::vector<std::size_t> founders = {};  ///< of each species

  /// The longest distance on the floor, m.
  [[nodiscard]] double diagonal_m() const { return 2.0 * std::numbers::sqrt2 * arena.half_side_m; }
};

}  // namespace trophic
