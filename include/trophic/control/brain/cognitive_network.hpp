// SPDX-License-Identifier: MIT
// The paper's network with its open choices: biases, and the turn for an output of zero.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/control/tanh_network.hpp>

namespace trophic::control::brain {

/// The turn for an angle output of exactly 0.
enum class ZeroTurns { left, right };

/// Fully connected tanh network with one hidden layer of 3 neurons and any number of inputs and outputs. Target angle +0.7 rad if
/// its output is > 0 (or >= 0 if zero turns right), else -0.7 rad; tag +1 if its output is > 0, else -1 (Sec. "Outputs").
/// Random draws: 0.
template <Biases biases, ZeroTurns zero>
struct CognitiveNetwork {
  static constexpr std::string_view name =
      zero == ZeroTurns::left
          ? (biases == Biases::none ? "cognitive_brain" : "cognitive_brain_with_biases")
          : (biases == Biases::none ? "cognitive_brain_zero_right" : "cognitive_brain_zero_right_with_biases");
  static constexpr std::string_view source =
      biases == Biases::none
          ? (zero == ZeroTurns::left ? "paper, Sec. \"Cognitive Brain\", \"Outputs\"; silent on hidden neurons" : "released code")
          : "not in the paper";
  using Network = TanhNetwork<3, biases>;
  using WithBiases = CognitiveNetwork<Biases::both_layers, zero>;  ///< the same brain with biases on both layers

  struct Params {
    double turn_angle_rad = 0.7;
    static constexpr auto fields() {
      return std::tuple{field("turn_angle_rad", &Params::turn_angle_rad, between(0.0, 3.141592653589793),
                              "absolute value of the target angle")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t outputs) const {
    return Network::weights_size(inputs, outputs);
  }
  [[nodiscard]] std::vector<std::size_t> neurons(std::size_t inputs, std::size_t outputs) const {
    return neurons_of<Network::bias>({inputs}, 3, outputs);
  }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }
  void evaluate(std::span<const double> inputs, std::span<const double> weights, std::span<double> outputs) const {
    Network::evaluate(inputs, weights, outputs);
  }
  [[nodiscard]] double target_angle_rad(double output) const {
    const bool right = zero == ZeroTurns::right ? output >= 0.0 : output > 0.0;
    return right ? params.turn_angle_rad : -params.turn_angle_rad;
  }
};

}  // namespace trophic::control::brain
