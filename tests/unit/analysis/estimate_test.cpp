// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/statistics/estimate.hpp>
#include <vector>

using namespace trophic::analysis;

TEST_CASE("an estimate has what its number of runs allows") {
  CHECK(estimate({}).runs == 0);
  CHECK_FALSE(estimate({}).mean);
  CHECK_FALSE(estimate(std::vector{2.0}).deviation);
  const Estimate five = estimate(std::vector{1.0, 2.0, 3.0, 4.0, 5.0});
  CHECK(*five.mean == 3.0);
  CHECK(*five.deviation == doctest::Approx(1.5811388));
  CHECK_FALSE(five.interval);
  const Estimate six = estimate(std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 3.0});
  CHECK(six.interval->lower < 3.0);
  CHECK(six.interval->upper > 3.0);
}

TEST_CASE("a conclusion is where the whole interval lies") {
  CHECK(test_result(std::nullopt) == TestResult::unknown);
  CHECK(test_result(Interval{0.1, 0.2}) == TestResult::above);
  CHECK(test_result(Interval{-0.2, -0.1}) == TestResult::below);
  CHECK(test_result(Interval{-0.1, 0.1}) == TestResult::not_significant);
  CHECK(test_result(Interval{0.0, 0.1}) == TestResult::not_significant);
}
