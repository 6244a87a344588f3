// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <tools/analysis/metrics/series.hpp>

using trophic::analysis::Mean;
using trophic::analysis::WindowMean;

TEST_CASE("series: mean -> ignores missing values, and is missing if there is no value") {
  Mean mean;
  mean.add(std::optional<double>{});
  CHECK_FALSE(mean.value());
  mean.add(1.0);
  mean.add(std::optional{4.0});
  CHECK(*mean.value() == 2.5);
}

TEST_CASE("windows are closed at their end, time 0 is in the first, a window without values is none") {
  WindowMean mean{10.0};
  mean.add(0.0, 1.0);
  mean.add(10.0, 3.0);
  mean.add(30.5, 8.0);
  const auto series = mean.series();
  REQUIRE(series.size() == 4);
  CHECK(*series[0].value == 2.0);
  CHECK(series[0].time_s == 10.0);
  CHECK_FALSE(series[1].value);
  CHECK_FALSE(series[2].value);
  CHECK(*series[3].value == 8.0);
  CHECK(*mean.mean() == 4.0);
  CHECK(*mean.mean_of_points() == 5.0);
}

TEST_CASE("series: window of length 0 -> refused") {
  CHECK_THROWS_WITH_AS(WindowMean{0.0}, "window_s = 0: must be > 0", std::invalid_argument);
  CHECK_FALSE(WindowMean{1.0}.mean());
  CHECK(WindowMean{1.0}.series().empty());
}
