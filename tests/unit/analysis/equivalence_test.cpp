// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <tools/analysis/statistics/equivalence.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

std::vector<double> normal_values(std::uint64_t seed, std::size_t count, double mean, double deviation) {
  Rng rng{seed, Stream::user};
  std::vector<double> values(count);
  for (double& value : values) value = rng.normal(mean, deviation);
  return values;
}

}  // namespace

TEST_CASE("equal sets are equivalent, far ones different, scattered ones inconclusive, five runs unknown") {
  const std::vector<double> a{1.0, 1.1, 0.9, 1.0, 1.05, 0.95};
  const std::vector<double> far{2.0, 2.1, 1.9, 2.0, 2.05, 1.95};
  const std::vector<double> scattered{-3.0, 5.0, 1.0, 4.0, -2.0, 1.0};
  const auto same = test_equivalence(a, a, 0.2);
  CHECK(same.conclusion == Equivalence::equivalent);
  CHECK(*same.difference == 0.0);
  CHECK(same.interval->lower == doctest::Approx(-same.interval->upper).epsilon(0.2));
  const auto other = test_equivalence(a, far, 0.2);
  CHECK(other.conclusion == Equivalence::different);
  CHECK(*other.difference == doctest::Approx(1.0));
  CHECK(test_equivalence(a, scattered, 0.2).conclusion == Equivalence::inconclusive);
  const std::vector<double> five(a.begin(), a.end() - 1);
  const auto few = test_equivalence(a, five, 0.2);
  CHECK(few.conclusion == Equivalence::unknown);
  CHECK(*few.difference == doctest::Approx(0.01));
  CHECK_FALSE(few.interval);
}

TEST_CASE("a small difference that is sure is equivalent where the margin allows it") {
  const std::vector<double> a{1.00, 1.01, 0.99, 1.00, 1.01, 0.99};
  const std::vector<double> b{1.05, 1.06, 1.04, 1.05, 1.06, 1.04};
  CHECK(test_equivalence(a, b, 0.1).conclusion == Equivalence::equivalent);
  CHECK(test_equivalence(a, b, 0.04).conclusion == Equivalence::different);
}

TEST_CASE("sets that differ by the margin are called equivalent in 5 % of cases, of six runs as of thirty") {
  constexpr std::uint64_t trials = 4000;
  for (const std::size_t runs : {6UL, 30UL}) {
    int wrong = 0;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      const auto a = normal_values(2 * trial, runs, 0.0, 0.3);
      const auto b = normal_values(2 * trial + 1, runs, 1.0, 0.3);
      if (test_equivalence(a, b, 1.0).conclusion == Equivalence::equivalent) ++wrong;
    }
    CAPTURE(runs);
    CHECK(wrong > 0.035 * trials);
    CHECK(wrong < 0.065 * trials);
  }
}

TEST_CASE("equivalence: bad margin or level -> refused") {
  const std::vector<double> a{1.0, 2.0, 1.0, 2.0, 1.0, 2.0};
  CHECK_THROWS_AS((void)test_equivalence(a, a, 0.0), std::invalid_argument);
  CHECK_THROWS_AS((void)test_equivalence(a, a, std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS((void)test_equivalence(a, a, 1.0, 0.5), std::invalid_argument);
}
