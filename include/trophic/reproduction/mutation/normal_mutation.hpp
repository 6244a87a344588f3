// SPDX-License-Identifier: MIT
// The paper's mutation: a normal perturbation of every weight.
#pragma once

#include <trophic/reproduction/mutation/contract.hpp>

namespace trophic::reproduction::mutation {

/// Rule: w <- w + N(0, sd) for every weight (Sec. "Reproduction": "perturbing the network weights with values drawn from a
/// normal distribution"); weights are not clipped. The paper does not give sd; the default, 0.05, is the half width of the
/// released code's uniform perturbation. Reads: the weights.   Random draws: 2 per weight.
struct NormalMutation {
  static constexpr std::string_view name = "normal_mutation";
  static constexpr std::string_view source = "paper, Sec. \"Reproduction\"; silent on the deviation";

  struct Params {
    double sd = 0.05;
    static constexpr auto fields() { return std::tuple{field("sd", &Params::sd, at_least(0.0), "standard deviation")}; }
  };
  Params params;

  void mutate(std::span<double> weights, const Individual&, Rng& rng) const {
    for (double& weight : weights) weight += rng.normal(0.0, params.sd);
  }
};
static_assert(Mutation<NormalMutation>);

}  // namespace trophic::reproduction::mutation
