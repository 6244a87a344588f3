// SPDX-License-Identifier: MIT
// The released code's mutation: a small uniform perturbation, clipped.
#pragma once

#include <trophic/reproduction/mutation/contract.hpp>

namespace trophic::reproduction::mutation {

/// Rule: w <- clip(w + U(-half_width, half_width), -limit, limit) for every weight (released code: 0.05 and 1). Reads: the
/// weights.   Random draws: 1 per weight.
struct UniformMutation {
  static constexpr std::string_view name = "uniform_mutation";
  static constexpr std::string_view source = "released code";

  struct Params {
    double half_width = 0.05;
    double limit = 1.0;
    static constexpr auto fields() {
      return std::tuple{field("half_width", &Params::half_width, at_least(0.0), "largest change of a weight"),
                        field("limit", &Params::limit, above(0.0), "bound on the absolute value of weights")};
    }
  };
  Params params;

  void mutate(std::span<double> weights, const Individual&, Rng& rng) const {
    for (double& weight : weights) {
      weight = std::clamp(weight + rng.uniform(-params.half_width, params.half_width), -params.limit, params.limit);
    }
  }
};
static_assert(Mutation<UniformMutation>);

}  // namespace trophic::reproduction::mutation
