// SPDX-License-Identifier: MIT
// Every new controller is inherited if there is a parent.
#pragma once

#include <string_view>
#include <trophic/reproduction/genome_source/contract.hpp>

namespace trophic::reproduction::genome_source {

/// Rule: a new controller comes from a parent; without a parent it is random and labelled random. There are no other random
/// newcomers.   Reads: nothing.   Random draws: 0.
struct AlwaysInherited {
  static constexpr std::string_view name = "always_inherited";
  static constexpr std::string_view source = "control";
  [[nodiscard]] Descent descent(Rng&) const { return Descent::of_parent; }
};
static_assert(GenomeSource<AlwaysInherited>);

}  // namespace trophic::reproduction::genome_source
