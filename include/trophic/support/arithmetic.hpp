// SPDX-License-Identifier: MIT
// Detects compiler flags that change the numbers of a run and define no macro; cpp20.hpp rejects those that define one.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace trophic {

namespace detail {

/// Returns how the code of this template deviates from plain double precision, and the flag that prevents it; empty if it does
/// not. Each `Compiled` has its own code, so flags of other files have no effect.
template <class Compiled>
[[nodiscard]] std::string_view changed_arithmetic() {
  const auto unknown = [](double value) {  // to the compiler
    volatile double kept = value;
    return static_cast<double>(kept);
  };
  const double near_one = unknown(1.0 + 0x1p-30);
  if (near_one * near_one + unknown(-1.0 - 0x1p-29) != 0.0) return "fuses multiplications with additions: -ffp-contract=off";
  const double large = unknown(1e16);
  if ((unknown(1.0) + large) - large != 0.0) return "reorders sums or keeps more digits: -fno-associative-math -mfpmath=sse";
  if (unknown(49.0) / 49.0 != 1.0) return "multiplies by reciprocals: -fno-reciprocal-math";
  const double zero = unknown(0.0);
  if (!std::signbit(-(zero - zero))) return "ignores the sign of zero: -fsigned-zeros";
  if (unknown(1.0) / unknown(10.0) != 0.1) return "has constants of single precision: -fno-single-precision-constant";
  if (unknown(std::numeric_limits<double>::min()) * 0.5 == 0.0)
    return "treats subnormal numbers as zero: -fno-fast-math, and linked with it";
  return {};
}

}  // namespace detail

/// Throws std::runtime_error if the code of `Compiled`, such as a rule table, was compiled in a way that changes the bytes of
/// runs.
template <class Compiled>
void check_arithmetic() {
  const std::string_view changed = detail::changed_arithmetic<Compiled>();
  if (changed.empty()) return;
  const std::size_t end = changed.find(": ");
  throw std::runtime_error{"this program was compiled so that it " + std::string{changed.substr(0, end)} +
                           ", which changes the numbers of a run: must be compiled with" + std::string{changed.substr(end + 1)}};
}

}  // namespace trophic
