// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/report/reading.hpp>

using namespace trophic::analysis;

TEST_CASE("velocities are read in cm/s, counts with one decimal, shares with three") {
  const Reading velocity{{"velocity", "prey", "all", "m/s"}};
  CHECK(velocity(0.01234) == "1.23");
  CHECK(velocity(0.01, true) == "+1.00");
  CHECK(Reading{{"deaths", "prey", "all", "1"}}(12.0) == "12.0");
  CHECK(Reading{{"hunger", "prey", "all", "ticks"}}(1.25) == "1.2");
  CHECK(Reading{{"wall_sticking", "prey", "all", "1"}}(0.25) == "0.250");
  CHECK(velocity(std::optional<double>{}) == "missing");
}

TEST_CASE("a mean is read with its interval, or its spread, or alone") {
  const Reading share{{"stuck", "prey", "all", "1"}};
  CHECK(share.of({.runs = 6, .mean = 0.5, .deviation = 0.1, .interval = Interval{0.4, 0.6}}) == "0.500 [0.400, 0.600]");
  CHECK(share.of({.runs = 2, .mean = 0.5, .deviation = 0.1, .interval = {}}) == "0.500 (sd 0.100)");
  CHECK(share.of({.runs = 1, .mean = 0.5, .deviation = {}, .interval = {}}) == "0.500");
  CHECK(share.of({}) == "missing");
}

TEST_CASE("a metric's title names whom it is about and the unit that is not plain") {
  CHECK(metric_title({"velocity", "prey", "random", "m/s"}) == "velocity prey (random), cm/s");
  CHECK(metric_title({"stuck", "all", "all", "1"}) == "stuck all");
}
