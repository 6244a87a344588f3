// SPDX-License-Identifier: MIT
// Bounds for a search for the closest robot.
#pragma once

#include <trophic/population/individual.hpp>

namespace trophic {

/// Marks of individuals, one bit per combination of species, tag and activity. Combinations may share a bit: individuals without
/// the mark are skipped, those with it must still be tested.
using Marks = std::uint64_t;
inline constexpr Marks every_mark = ~Marks{0};

[[nodiscard]] constexpr Marks mark_of(Species species, int tag, bool active) {
  const auto folded = static_cast<unsigned>(8 * (species % 8) + 2 * (static_cast<unsigned>(tag) % 4) + (active ? 1 : 0));
  return Marks{1} << folded;
}
[[nodiscard]] inline Marks mark_of(const Individual& individual) {
  return individual.lives() ? mark_of(individual.species, individual.tag, individual.active) : Marks{0};
}

/// All marks of a species, or only those of a given tag or of active individuals.
[[nodiscard]] constexpr Marks marks_of(Species species, std::optional<int> tag = {}, bool only_active = false) {
  Marks marks = 0;
  for (int any = 0; any < 4; ++any) {
    const int shown = tag.value_or(any);
    marks |= mark_of(species, shown, true);
    if (!only_active) marks |= mark_of(species, shown, false);
  }
  return marks;
}

/// The bounds of a search. Individuals farther away are not found. The caller guarantees that every acceptable individual has one
/// of the marks.
struct Search {
  double within_m = std::numeric_limits<double>::infinity();
  Marks among = every_mark;
};

}  // namespace trophic
