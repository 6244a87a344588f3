// SPDX-License-Identifier: MIT
// The arithmetic of the cognitive brain: a fully connected tanh network with one hidden layer, with or without biases.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>

namespace trophic::control::brain {

enum class Biases { none, both_layers };

/// hidden = tanh(W1 in + b1), out = tanh(W2 hidden + b2); without biases b1 = b2 = 0 and the network is odd in its inputs.
/// Weights in one row: W1 row by row, b1, W2 row by row, b2; without biases W1, W2.
template <std::size_t Inputs, std::size_t Hidden, std::size_t Outputs, Biases biases>
struct TanhNetwork {
  static constexpr std::size_t bias = biases == Biases::both_layers ? 1 : 0;
  static constexpr std::size_t weights_size = Hidden * (Inputs + bias) + Outputs * (Hidden + bias);

  /// The output neurons, each in (-1, 1). `weights` has weights_size elements.
  [[nodiscard]] static std::array<double, Outputs> outputs(const std::array<double, Inputs>& inputs,
                                                           std::span<const double> weights) {
    assert(weights.size() == weights_size);
    std::array<double, Hidden> hidden{};
    layer(inputs, hidden, weights.data());
    std::array<double, Outputs> out{};
    layer(hidden, out, weights.data() + Hidden * (Inputs + bias));
    return out;
  }

 private:
  /// to = tanh(W from + b); `weight` points to W row by row, then b.
  template <std::size_t From, std::size_t To>
  static void layer(const std::array<double, From>& from, std::array<double, To>& to, const double* weight) {
    for (std::size_t row = 0; row < To; ++row) {
      double sum = bias != 0 ? weight[To * From + row] : 0.0;
      for (std::size_t column = 0; column < From; ++column) sum += weight[row * From + column] * from[column];
      to[row] = std::tanh(sum);
    }
  }
};

}  // namespace trophic::control::brain
