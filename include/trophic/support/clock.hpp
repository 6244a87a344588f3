// SPDX-License-Identifier: MIT
// The ecology's clock: the time of a tick, and whether a time has passed.
#pragma once

#include <cmath>
#include <cstdint>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// Returns the time of a tick in seconds. If tick_s is a whole number of nanoseconds, such as 0.7 s, the result is the double
/// nearest to the decimal number: three ticks of 0.7 s are 2.1 s, whereas 3 * 0.7 in floating point is less.
[[nodiscard]] inline double clock_s(std::int64_t tick, double tick_s) {
  constexpr double per_s = 1e9;
  const double whole = std::round(tick_s * per_s);
  const double nanoseconds = static_cast<double>(tick) * whole;
  const bool is_whole = std::abs(tick_s * per_s - whole) <= 1e-6 && std::abs(nanoseconds) < 9e15;
  return is_whole ? nanoseconds / per_s : static_cast<double>(tick) * tick_s;
}

/// Whether `wait_s` have passed in `elapsed_s`, a difference of two times of a clock with this tick; a billionth of a tick counts
/// as rounding error.
[[nodiscard]] constexpr bool has_passed(double elapsed_s, double wait_s, double tick_s) {
  return elapsed_s >= wait_s - 1e-9 * tick_s;
}

}  // namespace trophic
