// SPDX-License-Identifier: MIT
// A fully connected network with one hidden layer.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <trophic/support/cpp20.hpp>
#include <vector>

namespace trophic::control {

enum class Biases { none, both_layers };

/// to = tanh(W from + b). `weight` points to W, row by row, followed by b if there are biases.
template <std::size_t bias>
void tanh_layer(std::span<const double> from, std::span<double> to, const double* weight) {
  for (std::size_t row = 0; row < to.size(); ++row) {
    double sum = bias != 0 ? weight[to.size() * from.size() + row] : 0.0;
    for (std::size_t column = 0; column < from.size(); ++column) sum += weight[row * from.size() + column] * from[column];
    to[row] = std::tanh(sum);
  }
}

/// The neuron that each weight of tanh_layers enters: first the hidden neurons, then the outputs.
template <std::size_t bias>
[[nodiscard]] std::vector<std::size_t> neurons_of(std::initializer_list<std::size_t> from, std::size_t hidden,
                                                  std::size_t outputs) {
  std::vector<std::size_t> neurons;
  const auto add = [&](std::size_t first, std::size_t before, std::size_t count) {
    for (std::size_t weight = 0; weight < count * before; ++weight) neurons.push_back(first + weight / before);
    for (std::size_t row = 0; row < count * bias; ++row) neurons.push_back(first + row);
  };
  for (const std::size_t before : from) add(0, before, hidden);
  add(hidden, hidden, outputs);
  return neurons;
}

/// hidden = tanh(W1 in + b1), out = tanh(W2 hidden + b2); without biases b1 = b2 = 0 and the network is odd in its inputs. Any
/// number of inputs and outputs. Weights in one row: W1 row by row, b1, W2 row by row, b2; without biases W1, W2.
template <std::size_t Hidden, Biases biases>
struct TanhNetwork {
  static constexpr std::size_t bias = biases == Biases::both_layers ? 1 : 0;
  [[nodiscard]] static constexpr std::size_t weights_size(std::size_t inputs, std::size_t outputs) {
    return Hidden * (inputs + bias) + outputs * (Hidden + bias);
  }

  /// Sets the output neurons and returns the hidden ones, each in (-1, 1). `weights` has weights_size(...) elements.
  static std::array<double, Hidden> evaluate(std::span<const double> inputs, std::span<const double> weights,
                                             std::span<double> out) {
    assert(weights.size() == weights_size(inputs.size(), out.size()));
    std::array<double, Hidden> hidden;
    tanh_layer<bias>(inputs, hidden, weights.data());
    tanh_layer<bias>(hidden, out, weights.data() + Hidden * (inputs.size() + bias));
    return hidden;
  }
};

}  // namespace trophic::control
