// SPDX-License-Identifier: MIT
// Individuals choose mates that are like them in a heritable trait.
#pragma once

#include <cmath>
#include <trophic/reproduction/recruitment/mate/contract.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::reproduction::recruitment::mate {

/// Rule: assortative mating. With x and y the trait of two individuals,
///   w = exp(-(strength (x - y))^2 / 2),
/// so 1 / strength is the standard deviation of the preference, in the trait's unit, and strength 0 is random mating. Dieckmann
/// and Doebeli's preference is such a Gaussian function, whose width evolves.   Reads: the trait.   Random draws: 0.
template <traits::Trait Trait>
struct AlikeIn {
  static constexpr std::string_view name = prefixed_name<"alike_in", Trait>;
  static constexpr std::string_view source = "not in the paper; [dieckmann1999]";
  using ReadsTraits = traits::List<Trait>;

  struct Params {
    double strength = 1.0;
    static constexpr auto fields() {
      return std::tuple{field("strength", &Params::strength, at_least(0.0),
                              "strength of the preference for a like mate, over the trait's unit; 0: random mating")};
    }
  };
  Params params;

  [[nodiscard]] double weight(BodyIndex self, BodyIndex other, const View& view) const {
    const double apart = params.strength * (view.trait<Trait>(self) - view.trait<Trait>(other));
    return std::exp(-0.5 * apart * apart);
  }
};

}  // namespace trophic::reproduction::recruitment::mate
