// SPDX-License-Identifier: MIT
// Forests of descent by hand.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <tools/reading/lineages.hpp>

namespace trophic::test {

inline constexpr double alive = std::numeric_limits<double>::infinity();

/// An individual of species 0 with one weight.
inline analysis::Taxon one(std::optional<std::size_t> parent, double birth_s, double death_s, double weight = 0.0,
                           Species species = 0) {
  return {.parent = parent, .birth_s = birth_s, .death_s = death_s, .species = species, .weights = {weight}};
}

/// Two trees: 0 has the offspring 1 and 2, 1 has 5, 2 has 3; 4 is alone. 0 and 2 die.
inline analysis::Forest two_trees() {
  return {one({}, 0.0, 50.0),  one(0, 10.0, alive),  one(0, 20.0, 60.0),
          one(2, 40.0, alive), one({}, 30.0, alive), one(1, 70.0, alive)};
}

}  // namespace trophic::test
