// SPDX-License-Identifier: MIT
// A small history with three catches.
#pragma once

#include <unit/reading/rows.hpp>
#include <vector>

namespace trophic::test {

inline constexpr Origin from_parent = Origin::inherited;
inline constexpr Origin drawn = Origin::random;

/// Prey 0 (random), 1 (random), 2 (inherited), hunters 3 (random), 4 (inherited). Hunter 4 catches 0 and 2, hunter 3 catches 1;
/// the caught bodies go to 5, 6, 7, all predators.
inline std::vector<analysis::EventRow> three_catches() {
  return {birth(0, 0, prey, 0, drawn),
          birth(0, 1, prey, 1, drawn),
          birth(0, 2, prey, 2, from_parent),
          birth(0, 3, predator, 3, drawn),
          birth(0, 4, predator, 4, from_parent),
          capture(2, 4, predator, 4, from_parent, 0),
          death(2, 0, prey, 0, drawn, Cause::caught),
          birth(2, 5, predator, 0, from_parent),
          capture(4, 4, predator, 4, from_parent, 2),
          death(4, 2, prey, 2, from_parent, Cause::caught),
          birth(4, 6, predator, 2, from_parent),
          capture(6, 3, predator, 3, drawn, 1),
          death(6, 1, prey, 1, drawn, Cause::caught),
          birth(6, 7, predator, 1, drawn)};
}

}  // namespace trophic::test
