// SPDX-License-Identifier: MIT
// A network whose hidden neurons remember the previous tick.
#pragma once

#include <trophic/control/brain/feed_forward_brain.hpp>

namespace trophic::control::brain {

/// Rule: a simple recurrent network [elman1990] of n hidden neurons: hidden(t) = tanh(W1 in(t) + R hidden(t - 1)), out = tanh(W2
/// hidden(t)), with one step per tick and hidden = 0 before the first decision of a life. Target angle and tag are as in
/// CognitiveBrain. With R = 0 it is FeedForwardBrain. Genome: W1 (n rows with one weight per input), R (n x n), W2 (one row of n
/// weights per output). Reads: the sensors, its hidden neurons of the previous tick.   Random draws: 0.
struct RecurrentBrain {
  static constexpr std::string_view name = "recurrent_brain";
  static constexpr std::string_view source = "not in the paper; recurrent links by [elman1990]";

  using Params = FeedForwardBrain::Params;
  Params params;

  struct State {
    std::vector<double> hidden;  ///< neurons of the previous tick; empty before the first decision
    static constexpr auto fields() { return std::tuple{field("hidden", &State::hidden)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }

  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t outputs) const {
    return params.hidden * (inputs + params.hidden + outputs);
  }
  [[nodiscard]] std::vector<std::size_t> neurons(std::size_t inputs, std::size_t outputs) const {
    return neurons_of<0>({inputs, params.hidden}, params.hidden, outputs);
  }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }

  /// Each output is in (-1, 1).
  void evaluate(std::span<const double> inputs, std::span<const double> weights, std::span<double> outputs, State& own) const {
    own.hidden = next_hidden(inputs, weights, own);
    set_outputs(own.hidden, inputs.size(), weights, outputs);
  }
  [[nodiscard]] double target_angle_rad(double output) const { return detail::either_side(output, params.turn_angle_rad); }

  /// Calls `visit(weight's index, neuron before, neuron after)` for each link of the next decision; for a link of R, the neuron
  /// before is that of the previous tick.
  template <class Visit>
  void for_each_link(std::span<const double> inputs, std::span<const double> weights, const State& own,
                     const Visit& visit) const {
    const std::vector<double> hidden = next_hidden(inputs, weights, own);
    std::size_t weight = 0;
    for (const double after : hidden) {
      for (const double before : inputs) visit(weight++, before, after);
    }
    for (const double after : hidden) {
      for (std::size_t before = 0; before < params.hidden; ++before) visit(weight++, remembered(own, before), after);
    }
    std::vector<double> outputs(weights.size() / params.hidden - inputs.size() - params.hidden);
    set_outputs(hidden, inputs.size(), weights, outputs);
    for (const double after : outputs) {
      for (const double before : hidden) visit(weight++, before, after);
    }
  }

 private:
  [[nodiscard]] static double remembered(const State& own, std::size_t neuron) {
    return own.hidden.empty() ? 0.0 : own.hidden[neuron];
  }

  [[nodiscard]] std::vector<double> next_hidden(std::span<const double> inputs, std::span<const double> weights,
                                                const State& own) const {
    const std::span recurrent = weights.subspan(params.hidden * inputs.size());
    std::vector<double> next(params.hidden);
    for (std::size_t row = 0; row < params.hidden; ++row) {
      double sum = 0.0;
      for (std::size_t i = 0; i < inputs.size(); ++i) sum += weights[row * inputs.size() + i] * inputs[i];
      for (std::size_t i = 0; i < params.hidden; ++i) sum += recurrent[row * params.hidden + i] * remembered(own, i);
      next[row] = std::tanh(sum);
    }
    return next;
  }

  void set_outputs(std::span<const double> hidden, std::size_t inputs, std::span<const double> weights,
                   std::span<double> outputs) const {
    tanh_layer<0>(hidden, outputs, weights.data() + params.hidden * (inputs + params.hidden));
  }
};
static_assert(Brain<RecurrentBrain>);

}  // namespace trophic::control::brain
