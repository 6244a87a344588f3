// SPDX-License-Identifier: MIT
// A trait that is drawn at each birth: the sex.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::reproduction::traits {

/// A trait for List. Rule: each newborn is female, sex 1, with probability `female_share`, and male, sex 0, otherwise. The sex is
/// a part of the genome, as a column of genomes.csv and for `view.trait<Sex>(body)`, but it is not inherited.
/// recruitment::mate::OtherSex reads it. Under the null `clones` all have one sex.   Reads: nothing.   Random draws: 1.
struct Sex {
  static constexpr std::string_view name = "sex";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double female_share = 0.5;
    static constexpr double first = 0.0, least = 0.0, most = 1.0;
    static constexpr auto fields() {
      return std::tuple{field("female_share", &Params::female_share, between(0.0, 1.0), "probability that a newborn is female")};
    }
    [[nodiscard]] double next(double, Rng& rng) const { return rng.chance(female_share) ? 1.0 : 0.0; }
    friend bool operator==(const Params&, const Params&) = default;
  };
};

}  // namespace trophic::reproduction::traits
