// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <tools/analysis/statistics/interval.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

const std::vector<double> six{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};

}  // namespace

TEST_CASE("a mean's interval is Student's: six values by hand") {
  // Mean 3.5, deviation sqrt(3.5), error sqrt(3.5 / 6) = 0.763763, t(5) = 2.570582 at 95 % and 2.015048 at 90 %.
  const auto wide = *interval_of_mean(six);
  CHECK(wide.lower == doctest::Approx(3.5 - 2.570582 * 0.763763).epsilon(1e-6));
  CHECK(wide.upper == doctest::Approx(3.5 + 2.570582 * 0.763763).epsilon(1e-6));
  CHECK(interval_of_mean(six, 0.90)->upper == doctest::Approx(3.5 + 2.015048 * 0.763763).epsilon(1e-6));
  CHECK(*deviation_of(six) == doctest::Approx(std::sqrt(3.5)));
}

TEST_CASE("below six runs there are mean and spread, but no interval") {
  for (std::size_t count = 0; count < six.size(); ++count) {
    const std::vector<double> few(six.begin(), six.begin() + static_cast<std::ptrdiff_t>(count));
    CHECK_FALSE(interval_of_mean(few));
    CHECK_FALSE(interval_of_difference(six, few));
    CHECK_FALSE(interval_of_difference(few, six));
    CHECK(mean_of(few).has_value() == (count > 0));
    CHECK(deviation_of(few).has_value() == (count > 1));
  }
}

TEST_CASE("a difference is Welch's: each set has its own spread") {
  const std::vector<double> a{2.0, 4.0, 6.0, 8.0, 10.0, 12.0};
  const auto of = *contrast({{-1.0, a}, {1.0, six}});
  CHECK(of.value == doctest::Approx(3.5 - 7.0));
  CHECK(of.error == doctest::Approx(std::sqrt(14.0 / 6.0 + 3.5 / 6.0)));
  // (v_a + v_b)^2 / (v_a^2 / 5 + v_b^2 / 5) with v_a = 4 v_b
  CHECK(of.freedom == doctest::Approx(25.0 / (17.0 / 5.0)));
  const auto interval = *interval_of_difference(a, six);
  CHECK(interval.upper - interval.lower == doctest::Approx(2.0 * 2.345856 * of.error).epsilon(2e-3));
}

TEST_CASE("equal spreads and equal numbers: the degrees of freedom of all sets together") {
  CHECK(contrast({{-1.0, six}, {1.0, six}})->freedom == doctest::Approx(10.0));
  CHECK(contrast({{-1.0, six}, {1.0, six}, {1.0, six}, {-1.0, six}})->freedom == doctest::Approx(20.0));
}

TEST_CASE("p values: 5 % at the edge of the interval, 1 for no difference, none where nothing varies or differs") {
  const auto of = contrast({{1.0, six}});
  CHECK(*p_value(of, interval_of(of)->lower) == doctest::Approx(0.05));
  CHECK(*p_value(of, 3.5) == doctest::Approx(1.0));
  const std::vector<double> constant(6, 0.1);
  const std::vector<double> other(6, 0.4);
  CHECK_FALSE(p_value(contrast({{-1.0, constant}, {1.0, constant}})));
  CHECK(*p_value(contrast({{-1.0, constant}, {1.0, other}})) == 0.0);
  CHECK_FALSE(p_value(std::nullopt));
  const auto point = *interval_of_mean(constant);
  CHECK(point.lower == point.upper);
}
