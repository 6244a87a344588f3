// SPDX-License-Identifier: MIT
// The paper's cognitive brain: a small fully connected network.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <trophic/control/concept.hpp>
#include <trophic/params.hpp>
#include <tuple>

namespace trophic::control {

/// Fully connected tanh network with one hidden layer of 3 and biases on both layers (Sec. "Cognitive Brain"; the paper
/// states no hidden size, 3-3-2 with biases is the released code's):
///   hidden = tanh(W1 in + b1), out = tanh(W2 hidden + b2), in = (angle, distance, tag ratio).
/// Target angle +0.7 rad if out[0] > 0, else -0.7 rad; tag +1 if out[1] > 0, else -1 (Sec. "Outputs"). Genome: W1 (3x3, row
/// by row), b1 (3), W2 (2x3), b2 (2): 20 weights.   Random draws: 0.
struct CognitiveBrain {
  static constexpr std::string_view name = "cognitive_brain";
  static constexpr int inputs_size = 3;
  static constexpr int hidden_size = 3;
  static constexpr int outputs_size = 2;

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

  [[nodiscard]] std::size_t genome_size() const { return hidden_size * (inputs_size + 1) + outputs_size * (hidden_size + 1); }

  [[nodiscard]] Decision decide(const perception::BrainInputs& inputs, std::span<const double> weights) const {
    const auto out = outputs(inputs, weights);
    const bool right = params.zero_turns_right ? out[0] >= 0.0 : out[0] > 0.0;
    return {.target_angle_rad = right ? params.turn_angle_rad : -params.turn_angle_rad, .tag = out[1] > 0.0 ? 1 : -1};
  }

  /// The two output neurons (target angle, tag), each in (-1, 1). `weights` has genome_size() elements.
  [[nodiscard]] std::array<double, outputs_size> outputs(const perception::BrainInputs& inputs,
                                                         std::span<const double> weights) const {
    assert(weights.size() == genome_size());
    const double* weight = weights.data();
    const std::array<double, inputs_size> in{inputs.angle, inputs.distance, inputs.tag_ratio};
    std::array<double, hidden_size> hidden{};
    layer(in, hidden, weight);
    std::array<double, outputs_size> out{};
    layer(hidden, out, weight + hidden_size * (inputs_size + 1));
    return out;
  }

 private:
  /// to = tanh(W from + b); `weight` points to W row by row, then b.
  template <std::size_t From, std::size_t To>
  static void layer(const std::array<double, From>& from, std::array<double, To>& to, const double* weight) {
    for (std::size_t row = 0; row < To; ++row) {
      double sum = weight[To * From + row];
      for (std::size_t column = 0; column < From; ++column) sum += weight[row * From + column] * from[column];
      to[row] = std::tanh(sum);
    }
  }
};
static_assert(Brain<CognitiveBrain>);

}  // namespace trophic::control
