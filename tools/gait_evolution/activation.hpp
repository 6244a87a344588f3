// SPDX-License-Identifier: MIT
// Activation functions: the output of a CPPN's node for its weighted sum.
#pragma once

#include <array>
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
[[nodiscard]] double activate(Activation activation, double sum);

}  // namespace trophic::gait_evolution
