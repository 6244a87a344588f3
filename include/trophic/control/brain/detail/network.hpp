// SPDX-License-Identifier: MIT
// Common to brains that are networks: the decision of two output neurons, and one step of Hebbian learning.
#pragma once

#include <trophic/control/brain/contract.hpp>

namespace trophic::control::brain::detail {

/// The paper's decision (Sec. "Outputs"): right if the first neuron is positive, else left; tag +1 if the second is, else -1.
[[nodiscard]] inline Decision decision_of(const std::array<double, Decision::outputs>& out, double turn_angle_rad) {
  return {.target_angle_rad = out[0] > 0.0 ? turn_angle_rad : -turn_angle_rad, .tag = out[1] > 0.0 ? 1 : -1};
}

/// The change of a weight by Oja's rule [oja1982], with x the neuron before it and y the one after: rate * y * (x - y * weight).
[[nodiscard]] inline double oja_step(double rate, double x, double y, double weight) {
  return rate * y * (x - y * weight);
}

}  // namespace trophic::control::brain::detail
