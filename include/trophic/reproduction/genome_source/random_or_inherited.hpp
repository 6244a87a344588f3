// SPDX-License-Identifier: MIT
// Some new controllers are random, the others inherit.
#pragma once

#include <string_view>
#include <trophic/params/params.hpp>
#include <trophic/reproduction/genome_source/contract.hpp>
#include <tuple>

namespace trophic::reproduction::genome_source {

/// Rule: a new controller is random with probability random_share, else sourced from a parent (Sec. "Reproduction": 1/3;
/// released code: 0.34). One that should inherit but finds no parent is random; the released code labels it inherited all
/// the same.   Reads: nothing.   Random draws: 1.
struct RandomOrInherited {
  static constexpr std::string_view name = "random_or_inherited";

  struct Params {
    double random_share = 1.0 / 3.0;
    bool orphans_labelled_inherited = false;
    static constexpr auto fields() {
      return std::tuple{
          field("random_share", &Params::random_share, between(0.0, 1.0), "probability that a new controller is random"),
          field("orphans_labelled_inherited", &Params::orphans_labelled_inherited,
                "a random genome for want of a parent counts as inherited")};
    }
  };
  Params params;

  [[nodiscard]] bool inherits(Rng& rng) const { return !rng.chance(params.random_share); }
  [[nodiscard]] Origin without_parent() const { return params.orphans_labelled_inherited ? Origin::inherited : Origin::random; }
};
static_assert(GenomeSource<RandomOrInherited>);

}  // namespace trophic::reproduction::genome_source
