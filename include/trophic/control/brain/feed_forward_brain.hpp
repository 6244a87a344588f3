// SPDX-License-Identifier: MIT
// The paper's network with any number of hidden neurons.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/control/brain/detail/network.hpp>
#include <trophic/control/tanh_network.hpp>

namespace trophic::control::brain {

/// Rule: hidden = tanh(W1 in), out = tanh(W2 hidden), with n hidden neurons and no biases (Sec. "Cognitive Brain", which does not
/// give n). Target angle and tag are as in CognitiveBrain, which is this brain with n = 3. Genome: W1 (n rows with one weight per
/// input), W2 (one row of n weights per output). Reads: the sensors.   Random draws: 0.
struct FeedForwardBrain {
  static constexpr std::string_view name = "feed_forward_brain";
  static constexpr std::string_view source = "paper, Sec. \"Cognitive Brain\"; silent on hidden neurons";

  struct Params {
    std::size_t hidden = 3;
    double turn_angle_rad = 0.7;
    static constexpr auto fields() {
      return std::tuple{field("hidden", &Params::hidden, between(1.0, 100.0), "hidden neurons").read_at_start(),
                        field("turn_angle_rad", &Params::turn_angle_rad, between(0.0, 3.141592653589793),
                              "absolute value of the target angle")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t outputs) const {
    return params.hidden * (inputs + outputs);
  }
  [[nodiscard]] std::vector<std::size_t> neurons(std::size_t inputs, std::size_t outputs) const {
    return neurons_of<0>({inputs}, params.hidden, outputs);
  }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }

  /// Each output is in (-1, 1).
  void evaluate(std::span<const double> inputs, std::span<const double> weights, std::span<double> outputs) const {
    propagate(inputs, weights, outputs);
  }
  /// The same for many, without memory for each.
  void evaluate_all(std::span<const double> inputs, std::span<const std::span<const double>> genomes,
                    std::span<double> outputs) const {
    std::vector<double> hidden(params.hidden);
    const std::size_t in = genomes.empty() ? 0 : inputs.size() / genomes.size();
    const std::size_t out = genomes.empty() ? 0 : outputs.size() / genomes.size();
    for (std::size_t i = 0; i < genomes.size(); ++i) {
      tanh_layer<0>(inputs.subspan(i * in, in), hidden, genomes[i].data());
      tanh_layer<0>(hidden, outputs.subspan(i * out, out), genomes[i].data() + params.hidden * in);
    }
  }
  [[nodiscard]] double target_angle_rad(double output) const { return detail::either_side(output, params.turn_angle_rad); }

  /// Calls `visit(weight's index, neuron before, neuron after)` for each link.
  template <class Visit>
  void for_each_link(std::span<const double> inputs, std::span<const double> weights, const Visit& visit) const {
    std::vector<double> outputs(weights.size() / params.hidden - inputs.size());
    const std::vector<double> hidden = propagate(inputs, weights, outputs);
    std::size_t weight = 0;
    for (const double after : hidden) {
      for (const double before : inputs) visit(weight++, before, after);
    }
    for (const double after : outputs) {
      for (const double before : hidden) visit(weight++, before, after);
    }
  }

 private:
  /// Sets the outputs and returns the hidden neurons.
  std::vector<double> propagate(std::span<const double> inputs, std::span<const double> weights,
                                std::span<double> outputs) const {
    std::vector<double> hidden(params.hidden);
    tanh_layer<0>(inputs, hidden, weights.data());
    tanh_layer<0>(hidden, outputs, weights.data() + params.hidden * inputs.size());
    return hidden;
  }
};
static_assert(Brain<FeedForwardBrain> && EvaluatesAll<FeedForwardBrain>);

}  // namespace trophic::control::brain
