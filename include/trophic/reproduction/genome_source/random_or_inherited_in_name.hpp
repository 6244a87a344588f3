// SPDX-License-Identifier: MIT
// Some new controllers are random, the others inherited; those without a parent are labelled inherited.
#pragma once

#include <string_view>
#include <trophic/reproduction/genome_source/contract.hpp>
#include <trophic/reproduction/genome_source/detail/random_share.hpp>

namespace trophic::reproduction::genome_source {

/// Rule (released code: 0.34): like RandomOrInherited, but a genome that is random for lack of a parent is labelled inherited:
/// the label follows the draw, not the descent.   Reads: nothing.   Random draws: 1.
struct RandomOrInheritedInName {
  static constexpr std::string_view name = "random_or_inherited_in_name";
  static constexpr std::string_view source = "released code";

  using Params = detail::RandomShare;
  Params params;

  [[nodiscard]] Descent descent(Rng& rng) const {
    return rng.chance(params.random_share) ? Descent::random : Descent::of_parent_in_name;
  }
};
static_assert(GenomeSource<RandomOrInheritedInName>);

}  // namespace trophic::reproduction::genome_source
