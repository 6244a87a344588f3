// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <tools/analysis/statistics/power.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("power of a t test as in printed tables") {
  // One sample, half a deviation: 34 runs.
  CHECK(power_of_t(0.5 * std::sqrt(34.0), 33.0, 0.05) == doctest::Approx(0.8078).epsilon(1e-3));
  // Two samples of 64 that are half a deviation apart, and of 26 that are 0.8 apart.
  CHECK(power_of_t(0.5 * std::sqrt(32.0), 126.0, 0.05) == doctest::Approx(0.8015).epsilon(1e-3));
  CHECK(power_of_t(0.8 * std::sqrt(13.0), 50.0, 0.05) == doctest::Approx(0.8075).epsilon(1e-3));
  CHECK(power_of_t(0.0, 7.0, 0.05) == doctest::Approx(0.05));
  CHECK(power_of_t(-3.0, 7.0, 0.01) == power_of_t(3.0, 7.0, 0.01));
}

TEST_CASE("power far away: one, and no step where the formula changes") {
  CHECK(power_of_t(1e9, 5.0, 1e-9) == doctest::Approx(1.0));
  CHECK(power_of_t(1e9, 1.0, 0.05) == doctest::Approx(1.0));
  // One degree of freedom: 200 errors lie in the middle of the curve at this level.
  CHECK(power_of_t(200.0001, 1.0, 0.003) == doctest::Approx(power_of_t(199.9999, 1.0, 0.003)).epsilon(1e-4));
  CHECK(power_of_t(200.0, 1.0, 0.003) < 0.9);
  CHECK(runs_for_power(1e6, {.variance = 1.0, .freedom = 1.0}, 1e-7) == min_runs_for_test);
}

TEST_CASE("the fewest runs that are enough") {
  CHECK(runs_for_power(0.5, {.variance = 1.0, .freedom = 1.0}, 0.05) == 34);
  CHECK(runs_for_power(-0.5, {.variance = 2.0, .freedom = 2.0}, 0.05) == 64);
  CHECK(runs_for_power(0.2, {.variance = 2.0, .freedom = 2.0}, 0.05) == 394);
  CHECK(runs_for_power(0.8, {.variance = 2.0, .freedom = 2.0}, 0.05) == 26);
  CHECK(runs_for_power(100.0, {.variance = 1.0, .freedom = 1.0}, 0.05) == min_runs_for_test);
  CHECK(runs_for_power(1.0, {.variance = 0.0, .freedom = 1.0}, 0.05) == min_runs_for_test);
  CHECK_FALSE(runs_for_power(0.0, {.variance = 1.0, .freedom = 1.0}, 0.05));
  CHECK_FALSE(runs_for_power(1e-4, {.variance = 1.0, .freedom = 1.0}, 0.05));
  for (const double level : {0.05, 1e-3, 1e-6}) {
    for (const double difference : {0.05, 0.4, 1.0, 3.0}) {
      CAPTURE(level);
      CAPTURE(difference);
      const auto runs = static_cast<double>(*runs_for_power(difference, {.variance = 1.0, .freedom = 1.0}, level));
      CHECK(power_of_t(difference * std::sqrt(runs), runs - 1.0, level) >= 0.8);
      if (runs > min_runs_for_test) CHECK(power_of_t(difference * std::sqrt(runs - 1.0), runs - 2.0, level) < 0.8);
    }
  }
}

TEST_CASE("what the runs at hand would find, they find with 80 % power, at any level") {
  for (const double freedom : {5.0, 9.3, 38.0, 4000.0}) {
    for (const double level : {0.05, 1e-4, 1e-7}) {
      CAPTURE(freedom);
      CAPTURE(level);
      CHECK(power_of_t(errors_for_power(freedom, level), freedom, level) == doctest::Approx(0.8).epsilon(1e-6));
    }
  }
  CHECK(detectable_difference({.value = 1.0, .error = 2.0, .freedom = 9.0}, 0.05) == 2.0 * errors_for_power(9.0, 0.05));
  CHECK(detectable_difference({.value = 1.0, .error = 0.0, .freedom = 1.0}, 0.05) == 0.0);
}

TEST_CASE("scatter of pairs and of sets") {
  const std::vector<double> a{1.0, 2.0, 3.0};
  const std::vector<double> b{4.0, 6.0, 8.0};
  CHECK(scatter_of(b)->variance == doctest::Approx(4.0));
  CHECK(scatter_of(a, b)->variance == doctest::Approx(5.0));
  CHECK(scatter_of(a, b)->freedom == doctest::Approx(25.0 / 17.0));
  CHECK(scatter_of(a, a)->freedom == doctest::Approx(2.0));
  CHECK_FALSE(scatter_of(std::vector<double>{1.0}));
  CHECK_FALSE(scatter_of(a, std::vector<double>{1.0}));
}

TEST_CASE("level and power must make sense") {
  CHECK_THROWS_AS((void)runs_for_power(1.0, {.variance = 1.0, .freedom = 1.0}, 0.0), std::invalid_argument);
  CHECK_THROWS_AS((void)runs_for_power(1.0, {.variance = 1.0, .freedom = 1.0}, 0.05, 1.0), std::invalid_argument);
}
