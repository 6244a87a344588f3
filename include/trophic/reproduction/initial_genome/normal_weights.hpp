// SPDX-License-Identifier: MIT
// Random genomes with normally distributed weights.
#pragma once

#include <trophic/reproduction/initial_genome/contract.hpp>

namespace trophic::reproduction::initial_genome {

/// Rule: each weight is drawn from N(0, sd). The default sd is that of UniformWeights within +-1, 1 / sqrt(3), so the two
/// distributions differ only in shape. With sd = 0 all weights are zero.   Reads: nothing.   Random draws: 2 per weight.
struct NormalWeights {
  static constexpr std::string_view name = "normal_weights";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double sd = 0.5773502691896258;
    static constexpr auto fields() { return std::tuple{field("sd", &Params::sd, at_least(0.0), "standard deviation")}; }
  };
  Params params;

  void draw(std::span<double> weights, Rng& rng) const {
    for (double& weight : weights) weight = rng.normal(0.0, params.sd);
  }
};
static_assert(InitialGenome<NormalWeights>);

}  // namespace trophic::reproduction::initial_genome
