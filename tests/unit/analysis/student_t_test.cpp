// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <tools/analysis/statistics/student_t.hpp>

using namespace trophic::analysis;

TEST_CASE("student t: quantiles as in printed tables") {
  CHECK(student_t_quantile(0.975, 9.0) == doctest::Approx(2.262).epsilon(1e-3));
  CHECK(student_t_quantile(0.95, 5.0) == doctest::Approx(2.015).epsilon(1e-3));
  CHECK(student_t_quantile(0.5, 3.0) == doctest::Approx(0.0));
}

TEST_CASE("student t: with one degree of freedom it is Cauchy's, whose tails have a closed form") {
  for (const double t : {0.0, 0.3, 1.0, 12.7}) {
    CAPTURE(t);
    CHECK(student_t_two_sided(t, 1.0) == doctest::Approx(1.0 - 2.0 * std::atan(t) / std::numbers::pi));
  }
}

TEST_CASE("student t: the tails beyond a quantile have the probability that it leaves") {
  for (const double freedom : {1.0, 4.5, 200.0}) {
    CAPTURE(freedom);
    CHECK(student_t_two_sided(student_t_quantile(0.975, freedom), freedom) == doctest::Approx(0.05));
  }
}
