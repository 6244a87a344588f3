// SPDX-License-Identifier: MIT
// What a CPPN's node makes of its weighted sum.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace trophic::gait_evolution {

enum class Activation : std::uint8_t { sine, gaussian, tanh, step, linear, abs };
[[nodiscard]] constexpr std::array<std::string_view, 6> enum_names(Activation) {
  return {"sine", "gaussian", "tanh", "step", "linear", "abs"};
}
inline constexpr std::array all_activations{Activation::sine, Activation::gaussian, Activation::tanh,
                                            Activation::step, Activation::linear,   Activation::abs};

/// sin(x), exp(-x^2), tanh(x), 1 for x >= 0 and else 0, x, |x|; with x = `sum` clipped to +-1e6, so that no chain of nodes
/// leaves the finite numbers.
[[nodiscard]] inline double activate(Activation activation, double sum) {
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
