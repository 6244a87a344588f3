// SPDX-License-Identifier: MIT
// Individuals choose mates whose brains have similar weights.
#pragma once

#include <cmath>
#include <trophic/reproduction/recruitment/mate/contract.hpp>

namespace trophic::reproduction::recruitment::mate {

/// Rule: with d the root mean square difference between the weights of two brains,
///   w = exp(-(strength d)^2 / 2);
/// strength 0 is random mating. Brains with different numbers of weights have w = 0 at any other strength.   Reads: weights.
/// Random draws: 0.
struct AlikeGenomes {
  static constexpr std::string_view name = "alike_genomes";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double strength = 1.0;
    static constexpr auto fields() {
      return std::tuple{field("strength", &Params::strength, at_least(0.0),
                              "strength of the preference for a mate with similar weights; 0: random mating")};
    }
  };
  Params params;

  [[nodiscard]] double weight(BodyIndex self, BodyIndex other, const View& view) const {
    const auto& own = view.robots[self].genome->weights;
    const auto& its = view.robots[other].genome->weights;
    if (params.strength == 0.0 || own == its) return 1.0;
    if (own.size() != its.size()) return 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) sum += (own[i] - its[i]) * (own[i] - its[i]);
    return std::exp(-0.5 * params.strength * params.strength * sum / static_cast<double>(own.size()));
  }
};
static_assert(MatePreference<AlikeGenomes>);

}  // namespace trophic::reproduction::recruitment::mate
