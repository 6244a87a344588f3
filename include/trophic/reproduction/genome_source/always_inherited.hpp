// SPDX-License-Identifier: MIT
// Every new controller inherits if it has a parent.
#pragma once

#include <string_view>
#include <trophic/reproduction/genome_source/contract.hpp>

namespace trophic::reproduction::genome_source {

/// Rule: a new controller is sourced from a parent; one without a parent is random and labelled so. There are no other random
/// newcomers.   Reads: nothing.   Random draws: 0.
struct AlwaysInherited {
  static constexpr std::string_view name = "always_inherited";
  static constexpr std::string_view source = "control";
  [[nodiscard]] Descent descent(Rng&) const { return Descent::of_parent; }
};
static_assert(GenomeSource<AlwaysInherited>);

}  // namespace trophic::reproduction::genome_source
