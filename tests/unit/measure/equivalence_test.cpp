// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <trophic/measure/equivalence.hpp>
#include <trophic/rng.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::measure;

namespace {

std::vector<double> normal_values(std::uint64_t seed, std::size_t count, double mean, double deviation) {
  Rng rng{seed, Stream::user};
  std::vector<double> values(count);
  for (double& value : values) value = rng.normal(mean, deviation);
  return values;
}

}  // namespace

TEST_CASE("equal sets are equivalent, far ones different, scattered ones undecided, single ones unknown") {
  const std::vector<double> a{1.0, 1.1, 0.9, 1.0, 1.05, 0.95};
  const std::vector<double> far{2.0, 2.1, 1.9, 2.0, 2.05, 1.95};
  const std::vector<double> scattered{-3.0, 5.0, 1.0, 4.0, -2.0, 1.0};
  const auto same = test_equivalence(a, a, 0.2);
  CHECK(same.verdict == Equivalence::equivalent);
  CHECK(*same.difference == 0.0);
  CHECK(same.interval->lower == doctest::Approx(-same.interval->upper).epsilon(0.2));
  const auto other = test_equivalence(a, far, 0.2);
  CHECK(other.verdict == Equivalence::different);
  CHECK(*other.difference == doctest::Approx(1.0));
  CHECK(test_equivalence(a, scattered, 0.2).verdict == Equivalence::undecided);
  CHECK(test_equivalence(a, std::vector<double>{1.0}, 0.2).verdict == Equivalence::unknown);
}

TEST_CASE("a small difference that is sure is equivalent where the margin allows it") {
  const std::vector<double> a{1.00, 1.01, 0.99, 1.00};
  const std::vector<double> b{1.05, 1.06, 1.04, 1.05};
  CHECK(test_equivalence(a, b, 0.1).verdict == Equivalence::equivalent);
  CHECK(test_equivalence(a, b, 0.04).verdict == Equivalence::different);
}

TEST_CASE("sets that differ by the margin are called equivalent about once in twenty times") {
  constexpr std::uint64_t trials = 400;
  int wrong = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const auto a = normal_values(2 * trial, 30, 0.0, 1.0);
    const auto b = normal_values(2 * trial + 1, 30, 1.0, 1.0);
    if (test_equivalence(a, b, 1.0, 0.05, {.resamples = 400}).verdict == Equivalence::equivalent) ++wrong;
  }
  // 5 % of 400 is 20, standard deviation 4.4; the bootstrap adds about 1 %.
  CHECK(wrong > 5);
  CHECK(wrong < 40);
}

TEST_CASE("margin and level must make sense") {
  const std::vector<double> a{1.0, 2.0};
  CHECK_THROWS_AS((void)test_equivalence(a, a, 0.0), std::invalid_argument);
  CHECK_THROWS_AS((void)test_equivalence(a, a, std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS((void)test_equivalence(a, a, 1.0, 0.5), std::invalid_argument);
}
