// SPDX-License-Identifier: MIT
// The paper's network with a number of hidden neurons.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/control/brain/detail/network.hpp>
#include <trophic/control/tanh_network.hpp>

namespace trophic::control::brain {

/// Rule: hidden = tanh(W1 in), out = tanh(W2 hidden), with n hidden neurons and no biases (Sec. "Cognitive Brain", which states
/// no n); decision as in CognitiveBrain, which is this brain with n = 3. Genome: W1 (n rows of one weight an input), W2 (2 x n).
/// Reads: the sensors.   Random draws: 0.
struct FeedForwardBrain {
  static constexpr std::string_view name = "feed_forward_brain";
  static constexpr std::string_view source = "paper, Sec. \"Cognitive Brain\"; silent on hidden neurons";

  struct Params {
    std::size_t hidden = 3;
    double turn_angle_rad = 0.7;
    static constexpr auto fields() {
      return std::tuple{
          field("hidden", &Params::hidden, between(1.0, 100.0), "hidden neurons"),
          field("turn_angle_rad", &Params::turn_angle_rad, between(0.0, 3.141592653589793), "size of the target angle")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t outputs) const {
    return params.hidden * (inputs + outputs);
  }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }

  [[nodiscard]] Decision decide(std::span<const double> inputs, std::span<const double> weights) const {
    return detail::decision_of(outputs(inputs, weights), params.turn_angle_rad);
  }

  /// The two output neurons (target angle, tag), each in (-1, 1).
  [[nodiscard]] std::array<double, Decision::outputs> outputs(std::span<const double> inputs,
                                                              std::span<const double> weights) const {
    return neurons(inputs, weights).out;
  }

  /// Calls `visit(weight's index, neuron before, neuron after)` for each link.
  template <class Visit>
  void for_each_link(std::span<const double> inputs, std::span<const double> weights, const Visit& visit) const {
    const Neurons all = neurons(inputs, weights);
    std::size_t weight = 0;
    for (const double after : all.hidden) {
      for (const double before : inputs) visit(weight++, before, after);
    }
    for (const double after : all.out) {
      for (const double before : all.hidden) visit(weight++, before, after);
    }
  }

 private:
  struct Neurons {
    std::vector<double> hidden;
    std::array<double, Decision::outputs> out{};
  };
  [[nodiscard]] Neurons neurons(std::span<const double> inputs, std::span<const double> weights) const {
    Neurons all{.hidden = std::vector<double>(params.hidden)};
    tanh_layer<0>(inputs, all.hidden, weights.data());
    tanh_layer<0>(all.hidden, all.out, weights.data() + params.hidden * inputs.size());
    return all;
  }
};
static_assert(Brain<FeedForwardBrain>);

}  // namespace trophic::control::brain
