// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <trophic/measure/bootstrap.hpp>
#include <trophic/measure/series.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::measure;

TEST_CASE("there is no interval of fewer than two values, and a point of equal ones") {
  CHECK_FALSE(bootstrap_mean(std::vector<double>{}));
  CHECK_FALSE(bootstrap_mean(std::vector<double>{1.0}));
  CHECK_FALSE(bootstrap_difference(std::vector<double>{1.0, 2.0}, std::vector<double>{1.0}));
  const auto interval = bootstrap_mean(std::vector<double>{4.0, 4.0, 4.0});
  CHECK(interval->lower == 4.0);
  CHECK(interval->upper == 4.0);
  CHECK_FALSE(mean_of(std::vector<double>{}));
}

TEST_CASE("two values resample to three means: quarters at the ends") {
  const std::vector<double> values{0.0, 1.0};
  const auto wide = bootstrap_mean(values, {.level = 0.95});
  CHECK(wide->lower == 0.0);
  CHECK(wide->upper == 1.0);
  const auto narrow = bootstrap_mean(values, {.level = 0.4});  // 30 % to 70 %: inside the half that lies at 0.5
  CHECK(narrow->lower == 0.5);
  CHECK(narrow->upper == 0.5);
}

TEST_CASE("95 % intervals of 40 normal values are 1.96 standard errors wide and cover the truth about as often") {
  int covered = 0;
  Mean width;
  constexpr int trials = 400;
  for (int trial = 0; trial < trials; ++trial) {
    Rng rng{static_cast<std::uint64_t>(trial), Stream::user};
    std::vector<double> values(40);
    for (double& value : values) value = rng.normal(3.0, 2.0);
    const auto interval = *bootstrap_mean(values, {.resamples = 1000});
    covered += interval.lower <= 3.0 && 3.0 <= interval.upper ? 1 : 0;
    width.add(interval.upper - interval.lower);
  }
  CHECK(covered > 0.89 * trials);
  CHECK(covered < 0.985 * trials);
  CHECK(*width.value() == doctest::Approx(2.0 * 1.96 * 2.0 / std::sqrt(40.0)).epsilon(0.05));
}

TEST_CASE("the difference is b - a, and the same seed gives the same interval") {
  const std::vector<double> a{1.0, 1.1, 0.9, 1.0};
  const std::vector<double> b{2.0, 2.1, 1.9, 2.0};
  const auto interval = *bootstrap_difference(a, b);
  CHECK(interval.lower > 0.8);
  CHECK(interval.upper < 1.2);
  CHECK(bootstrap_difference(a, b)->lower == interval.lower);
  CHECK(bootstrap_difference(a, b, {.seed = 2})->lower == doctest::Approx(interval.lower).epsilon(0.05));
}
