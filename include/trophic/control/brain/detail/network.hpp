// SPDX-License-Identifier: MIT
// Shared by brains that are networks: the two target angles of the paper, and one step of Hebbian learning.
#pragma once

#include <trophic/control/brain/contract.hpp>

namespace trophic::control::brain::detail {

/// The paper's target angle (Sec. "Outputs"): right if the output is positive, else left.
[[nodiscard]] inline double either_side(double output, double turn_angle_rad) {
  return output > 0.0 ? turn_angle_rad : -turn_angle_rad;
}

/// The change of a weight by Oja's rule [oja1982], where x is the neuron before it and y the one after: rate * y * (x - y *
/// weight).
[[nodiscard]] inline double oja_step(double rate, double x, double y, double weight) {
  return rate * y * (x - y * weight);
}

}  // namespace trophic::control::brain::detail
