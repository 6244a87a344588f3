// SPDX-License-Identifier: MIT
// The paper's cognitive brain: a small fully connected network.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <trophic/control/brain/contract.hpp>
#include <trophic/control/brain/tanh_network.hpp>
#include <trophic/params/params.hpp>
#include <tuple>
#include <vector>

namespace trophic::control::brain {

/// Fully connected tanh network with one hidden layer, in = (angle, distance, tag ratio). Target angle +0.7 rad if out[0] > 0,
/// else -0.7 rad; tag +1 if out[1] > 0, else -1 (Sec. "Outputs").   Random draws: 0.
template <Biases biases>
struct CognitiveNetwork {
  static constexpr std::string_view name = biases == Biases::none ? "cognitive_brain" : "cognitive_brain_with_biases";
  using Network = TanhNetwork<3, 3, 2, biases>;

  struct Params {
    double turn_angle_rad = 0.7;
    bool zero_turns_right = false;  ///< an angle output of exactly 0 counts as positive (released code)
    static constexpr auto fields() {
      return std::tuple{
          field("turn_angle_rad", &Params::turn_angle_rad, between(0.0, 3.141592653589793), "size of the target angle"),
          field("zero_turns_right", &Params::zero_turns_right, "an angle output of 0 counts as positive")};
    }
  };
  Params params;

  [[nodiscard]] std::size_t genome_size() const { return Network::weights_size; }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }

  [[nodiscard]] Decision decide(const perception::BrainInputs& inputs, std::span<const double> weights) const {
    const auto out = outputs(inputs, weights);
    const bool right = params.zero_turns_right ? out[0] >= 0.0 : out[0] > 0.0;
    return {.target_angle_rad = right ? params.turn_angle_rad : -params.turn_angle_rad, .tag = out[1] > 0.0 ? 1 : -1};
  }

  /// The two output neurons (target angle, tag), each in (-1, 1). `weights` has genome_size() elements.
  [[nodiscard]] std::array<double, 2> outputs(const perception::BrainInputs& inputs, std::span<const double> weights) const {
    return Network::outputs({inputs.angle, inputs.distance, inputs.tag_ratio}, weights);
  }
};

/// The paper's brain (Sec. "Cognitive Brain", which names no bias): hidden = tanh(W1 in), out = tanh(W2 hidden). The paper states
/// no hidden size; 3 is the released code's. That code's genome carries biases and mutates them, but the line that adds them is
/// commented out in every published run. Genome: W1 (3x3, row by row), W2 (2x3): 15 weights.
using CognitiveBrain = CognitiveNetwork<Biases::none>;
static_assert(Brain<CognitiveBrain>);

}  // namespace trophic::control::brain
