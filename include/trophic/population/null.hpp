// SPDX-License-Identifier: MIT
// A run's null model: the table's inheritance, or its substitute.
#pragma once

#include <array>
#include <string_view>

namespace trophic {

/// A metric that differs from the shadow's shows the effect of inheritance; a measure of genomes, bodies or brains that differs
/// from the neutral null's shows the effect of selection.
enum class Null {
  none,     ///< the table's heredity
  shadow,   ///< the heredity rule is not applied: every inherited genome is drawn anew, so that nothing accumulates
  neutral,  ///< births, deaths and parents are those of a run, genomes others: nothing is selected (ecology/history.hpp)
  clones    ///< all have the genome that the first founder draws, and none mutates: nothing can differ
};
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(Null) {
  return {"none", "shadow", "neutral", "clones"};
}

}  // namespace trophic
