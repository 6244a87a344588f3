// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/statistics/holm.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using trophic::analysis::holm;

TEST_CASE("Holm: the smallest counts for all, none passes an earlier one, none is above 1") {
  const auto adjusted = holm(std::vector<double>{0.01, 0.9, 0.04, 0.03});
  CHECK(adjusted[0] == doctest::Approx(0.04));
  CHECK(adjusted[3] == doctest::Approx(0.09));
  CHECK(adjusted[2] == doctest::Approx(0.09));  // 2 x 0.04 = 0.08 would pass the one before
  CHECK(adjusted[1] == doctest::Approx(0.9));
  CHECK(holm(std::vector<double>{0.6, 0.7})[0] == 1.0);
  CHECK(holm({}).empty());
  CHECK(holm(std::vector<double>{0.05})[0] == 0.05);
}

TEST_CASE("Holm: twenty comparisons without an effect -> a significant one in 5 % of analyses") {
  trophic::Rng rng{11, trophic::Stream::user};
  int found = 0;
  constexpr int trials = 4000;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> p_values(20);
    for (double& p : p_values) p = rng.uniform(0.0, 1.0);
    for (const double p : holm(p_values)) {
      if (p > 0.05) continue;
      ++found;
      break;
    }
  }
  CHECK(found > 0.035 * trials);
  CHECK(found < 0.065 * trials);
}
