// SPDX-License-Identifier: MIT
// How a central pattern generator steps.
#pragma once

#include <array>
#include <string_view>

namespace trophic {

/// How a CPG steps. `exact`: the matrix exponential exp(W h). W is antisymmetric, so it is a rotation and amplitudes do not drift
/// (for weights that turn an oscillator by some radians a step at most; gaits' are far below).
/// `rk4`: classical Runge-Kutta, which for a linear system is exp's Taylor series up to h^4 (what the released code does).
enum class CpgIntegration { exact, rk4 };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(CpgIntegration) {
  return {"exact", "rk4"};
}

}  // namespace trophic
