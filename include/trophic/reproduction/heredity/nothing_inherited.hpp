// SPDX-License-Identifier: MIT
// The neutral heredity: parents are chosen and recorded, but no genome is passed on.
#pragma once

#include <trophic/reproduction/heredity/contract.hpp>

namespace trophic::reproduction::heredity {

/// Rule: an offspring has a parent, a place and a label as under any other heredity, but its genome is drawn anew. Selection has
/// nothing to act on, so any effect is due to the places and times of births. This is the null model of evolution (see
/// rules::neutral_shadow). Reads: nothing.   Random draws: those of the initial genome.
struct NothingInherited {
  static constexpr std::string_view name = "nothing_inherited";
  static constexpr std::string_view source = "control";
  [[nodiscard]] std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>&) const { return nullptr; }
};
static_assert(Heredity<NothingInherited>);

}  // namespace trophic::reproduction::heredity
