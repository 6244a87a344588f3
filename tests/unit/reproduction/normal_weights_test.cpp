// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <support/statistics.hpp>
#include <trophic/reproduction/initial_genome/normal_weights.hpp>
#include <trophic/reproduction/initial_genome/uniform_weights.hpp>
#include <vector>

using namespace trophic;
using reproduction::initial_genome::NormalWeights;
using reproduction::initial_genome::UniformWeights;

namespace {

template <class Policy>
test::Moments moments_of(const Policy& policy) {
  std::vector<double> weights(200'000, 17.0);
  Rng rng{16, Stream::initial_genome};
  policy.draw(weights, rng);
  return test::moments(weights);
}

}  // namespace

TEST_CASE("normal weights: sd -> weights are normal with mean 0 and that sd, whatever the genome held before") {
  const double size = 200'000.0;
  for (const double sd : {NormalWeights::Params{}.sd, 0.1, 3.0}) {
    CAPTURE(sd);
    const test::Moments drawn = moments_of(NormalWeights{{.sd = sd}});
    CHECK(std::abs(drawn.mean) < 4.0 * sd / std::sqrt(size));
    CHECK(std::abs(drawn.sd / sd - 1.0) < 4.0 / std::sqrt(2.0 * size));
    CHECK(std::abs(drawn.skewness) < 4.0 * std::sqrt(6.0 / size));
    CHECK(std::abs(drawn.kurtosis - 3.0) < 4.0 * std::sqrt(24.0 / size));
    CHECK(drawn.largest > 3.5 * sd);
  }
}

TEST_CASE("normal weights: default sd -> that of uniform weights") {
  CHECK(moments_of(NormalWeights{}).sd == doctest::Approx(moments_of(UniformWeights{}).sd).epsilon(0.01));
}

TEST_CASE("normal weights: sd 0 -> zeros") {
  std::vector<double> weights(20, 17.0);
  Rng rng{1, Stream::initial_genome};
  NormalWeights{{.sd = 0.0}}.draw(weights, rng);
  CHECK(weights == std::vector<double>(20, 0.0));
}
