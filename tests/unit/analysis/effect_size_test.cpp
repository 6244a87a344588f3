// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/statistics/effect_size.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("Hedges' correction has closed forms at few degrees of freedom") {
  CHECK(hedges_correction(2.0) == doctest::Approx(1.0 / std::sqrt(std::numbers::pi)));
  CHECK(hedges_correction(4.0) == doctest::Approx(std::sqrt(2.0 / std::numbers::pi)));
  CHECK(hedges_correction(18.0) == doctest::Approx(1.0 - 3.0 / (4.0 * 18.0 - 1.0)).epsilon(1e-3));
}

TEST_CASE("Hedges' g by hand") {
  const std::vector<double> a{1.0, 2.0, 3.0};
  const std::vector<double> b{4.0, 6.0, 8.0};
  // Means 2 and 6, variances 1 and 4: the pooled deviation is sqrt(2.5) with 4 degrees of freedom.
  CHECK(*hedges_g(a, b) == doctest::Approx(4.0 / std::sqrt(2.5) * std::sqrt(2.0 / std::numbers::pi)));
  CHECK(*hedges_g(a, b) == doctest::Approx(2.0185).epsilon(1e-4));
  CHECK(*hedges_g(b, a) == -*hedges_g(a, b));
  const std::vector<double> c{4.0, 6.0, 8.0, 6.0, 6.0};
  // Squares 2 and 8 over 2 + 4 degrees of freedom; the correction at 6 is 2 / sqrt(3) / (3 sqrt(pi) / 4).
  CHECK(*hedges_g(a, c) == doctest::Approx(4.0 / std::sqrt(10.0 / 6.0) * 8.0 / (3.0 * std::sqrt(3.0 * std::numbers::pi))));
}

TEST_CASE("Hedges' g: six runs or more -> unbiased, and no value without a spread") {
  Rng rng{3, Stream::user};
  constexpr int trials = 20000;
  double sum = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> a(6);
    std::vector<double> b(6);
    for (double& value : a) value = rng.normal(0.0, 2.0);
    for (double& value : b) value = rng.normal(1.6, 2.0);
    sum += *hedges_g(a, b);
  }
  CHECK(sum / trials == doctest::Approx(0.8).epsilon(0.02));
  const std::vector<double> flat{1.0, 1.0};
  CHECK_FALSE(hedges_g(flat, std::vector<double>{2.0, 2.0}));
  CHECK_FALSE(hedges_g(flat, std::vector<double>{2.0}));
}
