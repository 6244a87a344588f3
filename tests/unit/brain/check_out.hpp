// SPDX-License-Identifier: MIT
// The outputs of a brain against numbers computed by hand.
#pragma once

#include <doctest/doctest.h>

#include <array>

inline void check_out(const std::array<double, 2>& out, double first, double second) {
  CHECK(out[0] == doctest::Approx(first).epsilon(1e-14));
  CHECK(out[1] == doctest::Approx(second).epsilon(1e-14));
}
