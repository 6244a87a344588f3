// SPDX-License-Identifier: MIT
// The paper's network with weights that change within a life.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/control/brain/detail/network.hpp>
#include <trophic/control/tanh_network.hpp>

namespace trophic::control::brain {

/// Rule: CognitiveBrain with weights that learn. The genome g holds the weights at birth. After each decision every weight w =
/// g + learnt changes by Oja's rule [oja1982], a Hebbian rule that stays bounded:
///   learnt <- learnt + rate * y * (x - y * w), with x the neuron before and y the one after the weight.
/// Learning ends with the individual; its offspring inherit the genome unchanged.
/// Reads: the sensors.   Random draws: 0.
struct HebbianBrain {
  static constexpr std::string_view name = "hebbian_brain";
  static constexpr std::string_view source = "not in the paper; learning by [oja1982]";
  static constexpr std::size_t hidden = 3;
  using Network = TanhNetwork<hidden, Biases::none>;

  struct Params {
    double turn_angle_rad = 0.7;
    double rate = 0.01;
    static constexpr auto fields() {
      return std::tuple{
          field("turn_angle_rad", &Params::turn_angle_rad, between(0.0, 3.141592653589793), "size of the target angle"),
          field("rate", &Params::rate, between(0.0, 1.0), "learning rate per decision; 0: none")};
    }
  };
  Params params;

  /// The state of an individual.
  struct State {
    std::vector<double> learnt;  ///< added to each weight of the genome; empty before the first decision
    static constexpr auto fields() { return std::tuple{field("learnt", &State::learnt)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }

  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t outputs) const {
    return Network::weights_size(inputs, outputs);
  }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }

  /// The outputs before this decision's learning, each in (-1, 1).
  void evaluate(std::span<const double> inputs, std::span<const double> weights, std::span<double> outputs, State& own) const {
    own.learnt.resize(weights.size(), 0.0);
    const std::vector<double> sum = learnt_weights(weights, own);
    const auto before = Network::evaluate(inputs, sum, outputs);
    const std::span learnt{own.learnt};
    const std::size_t first = hidden * inputs.size();
    learn(inputs, before, std::span{sum}.first(first), learnt.first(first));
    learn(before, outputs, std::span{sum}.subspan(first), learnt.subspan(first));
  }
  [[nodiscard]] double target_angle_rad(double output) const { return detail::either_side(output, params.turn_angle_rad); }

 private:
  [[nodiscard]] static std::vector<double> learnt_weights(std::span<const double> weights, const State& own) {
    std::vector<double> sum(weights.begin(), weights.end());
    for (std::size_t i = 0; i < own.learnt.size(); ++i) sum[i] += own.learnt[i];
    return sum;
  }

  void learn(std::span<const double> from, std::span<const double> to, std::span<const double> weights,
             std::span<double> learnt) const {
    for (std::size_t row = 0; row < to.size(); ++row) {
      for (std::size_t column = 0; column < from.size(); ++column) {
        const std::size_t i = row * from.size() + column;
        learnt[i] += detail::oja_step(params.rate, from[column], to[row], weights[i]);
      }
    }
  }
};
static_assert(Brain<HebbianBrain>);

}  // namespace trophic::control::brain
