// SPDX-License-Identifier: MIT
// Definitions of activation.hpp.
#include <tools/gait_evolution/activation.hpp>

#include <algorithm>
#include <cmath>

namespace trophic::gait_evolution {

double activate(Activation activation, double sum) {
  const double x = std::clamp(sum, -1e6, 1e6);
  switch (activation) {
    case Activation::sine:
      return std::sin(x);
    case Activation::gaussian:
      return std::exp(-x * x);
    case Activation::tanh:
      return std::tanh(x);
    case Activation::step:
      return x >= 0.0 ? 1.0 : 0.0;
    case Activation::linear:
      return x;
    case Activation::abs:
      break;
  }
  return std::abs(x);
}

}  // namespace trophic::gait_evolution
