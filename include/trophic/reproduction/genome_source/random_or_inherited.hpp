// SPDX-License-Identifier: MIT
// Some new controllers are random, the others inherit.
#pragma once

#include <string_view>
#include <trophic/reproduction/genome_source/contract.hpp>
#include <trophic/reproduction/genome_source/detail/random_share.hpp>

namespace trophic::reproduction::genome_source {

/// Rule: a new controller is random with probability random_share, else sourced from a parent (Sec. "Reproduction": 1/3). One
/// that should inherit but finds no parent is random and labelled so; RandomOrInheritedInName is the released code's.   Reads:
/// nothing.   Random draws: 1.
struct RandomOrInherited {
  static constexpr std::string_view name = "random_or_inherited";
  static constexpr std::string_view source = "paper, Sec. \"Reproduction\"";

  using Params = detail::RandomShare;
  Params params;

  [[nodiscard]] Descent descent(Rng& rng) const { return rng.chance(params.random_share) ? Descent::random : Descent::of_parent; }
};
static_assert(GenomeSource<RandomOrInherited>);

}  // namespace trophic::reproduction::genome_source
