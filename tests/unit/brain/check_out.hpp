// SPDX-License-Identifier: MIT
// The outputs and decisions of a brain, and a check against numbers computed by hand.
#pragma once

#include <doctest/doctest.h>

#include <trophic/control/brain/contract.hpp>

namespace trophic::test {

/// The two output neurons in a table with the paper's acts; `own` does not change.
template <class Brain>
[[nodiscard]] std::array<double, 2> outputs(const Brain& brain, std::span<const double> inputs, std::span<const double> weights,
                                            StateOf<Brain> own = {}) {
  std::array<double, 2> out{};
  control::ask::evaluate(brain, own, inputs, weights, out);
  return out;
}
template <class Brain>
[[nodiscard]] control::Decision decide(const Brain& brain, std::span<const double> inputs, std::span<const double> weights,
                                       StateOf<Brain>& own) {
  return control::ask::decide(brain, own, inputs, weights);
}
template <class Brain>
[[nodiscard]] control::Decision decide(const Brain& brain, std::span<const double> inputs, std::span<const double> weights) {
  StateOf<Brain> own{};
  return decide(brain, inputs, weights, own);
}

}  // namespace trophic::test

inline void check_out(const std::array<double, 2>& out, double first, double second) {
  CHECK(out[0] == doctest::Approx(first).epsilon(1e-14));
  CHECK(out[1] == doctest::Approx(second).epsilon(1e-14));
}
