// SPDX-License-Identifier: MIT
// Random genomes with uniformly distributed weights.
#pragma once

#include <trophic/reproduction/initial_genome/contract.hpp>

namespace trophic::reproduction::initial_genome {

/// Rule: each weight is uniform in [-limit, limit), with limit 1 (Sec. "Initialization": "entirely randomized weights between -1
/// and 1 drawn from a uniform distribution"). Biases of a brain, which the paper does not mention, are among its weights. Reads:
/// nothing.   Random draws: 1 per weight.
struct UniformWeights {
  static constexpr std::string_view name = "uniform_weights";
  static constexpr std::string_view source = "paper, Sec. \"Initialization\"";

  struct Params {
    double limit = 1.0;
    static constexpr auto fields() {
      return std::tuple{field("limit", &Params::limit, at_least(0.0), "bound on the absolute value of weights")};
    }
  };
  Params params;

  void draw(std::span<double> weights, Rng& rng) const {
    for (double& weight : weights) weight = rng.uniform(-params.limit, params.limit);
  }
};
static_assert(InitialGenome<UniformWeights>);

}  // namespace trophic::reproduction::initial_genome
