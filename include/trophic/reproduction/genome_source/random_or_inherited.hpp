// SPDX-License-Identifier: MIT
// Some new controllers are random, the others inherited.
#pragma once

#include <string_view>
#include <trophic/reproduction/genome_source/contract.hpp>
#include <trophic/reproduction/genome_source/detail/random_share.hpp>

namespace trophic::reproduction::genome_source {

/// Rule: a new controller is random with probability random_share (Sec. "Reproduction": 1/3) and otherwise comes from a parent.
/// If there is no parent, it is random and labelled random; in the released code it is labelled inherited
/// (RandomOrInheritedInName).   Reads: nothing.   Random draws: 1.
struct RandomOrInherited {
  static constexpr std::string_view name = "random_or_inherited";
  static constexpr std::string_view source = "paper, Sec. \"Reproduction\"";

  using Params = detail::RandomShare;
  Params params;

  [[nodiscard]] Descent descent(Rng& rng) const { return rng.chance(params.random_share) ? Descent::random : Descent::of_parent; }
};
static_assert(GenomeSource<RandomOrInherited>);

}  // namespace trophic::reproduction::genome_source
