// SPDX-License-Identifier: MIT
// A world before its run, from which a rule can determine that its parameters leave it idle.
#pragma once

#include <cstddef>
#include <numbers>
#include <string>
#include <trophic/habitat/arena.hpp>
#include <trophic/population/food_web.hpp>
#include <vector>

namespace trophic {

/// A rule of any slot may have `std::string idle(const Outset& outset) const`: it returns a sentence if the rule's parameters
/// never let it act in this world, and "" otherwise. The program prints the sentence before the run and records it in the
/// manifest's remarks.
struct Outset {
  const FoodWeb& web;
  const Arena& arena;
  std::size_t robots = 0;                  ///< bodies
  std::vector<std::size_t> founders = {};  ///< of each species

  /// The longest distance on the floor, m.
  [[nodiscard]] double diagonal_m() const { return 2.0 * std::numbers::sqrt2 * arena.half_side_m; }
};

}  // namespace trophic
