// SPDX-License-Identifier: MIT
// The integration of a central pattern generator.
#pragma once

#include <array>
#include <string_view>

namespace trophic {

/// The integration of a CPG. `exact`: the matrix exponential exp(W h). W is antisymmetric, so it is a rotation and amplitudes
/// do not drift (for weights that turn an oscillator by at most some radians a step; those of gaits are far below). `rk4`:
/// classical Runge-Kutta, which for a linear system is exp's Taylor series up to h^4 (as in the released code).
enum class CpgIntegration { exact, rk4 };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(CpgIntegration) {
  return {"exact", "rk4"};
}

}  // namespace trophic
