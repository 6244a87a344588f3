// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <cmath>
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

TEST_CASE("uniform weights: any previous content -> uniform in -1 to below 1") {
  std::vector<double> weights(200'000, 17.0);
  Rng rng{14, Stream::initial_genome};
  UniformWeights{}.draw(weights, rng);
  const test::Moments drawn = test::moments(weights);
  const double sd = 2.0 / std::sqrt(12.0);
  const double size = 200'000.0;
  CHECK(std::abs(drawn.mean) < 4.0 * sd / std::sqrt(size));
  CHECK(std::abs(drawn.sd / sd - 1.0) < 4.0 * std::sqrt(0.8 / (4.0 * size)));
  CHECK(std::abs(drawn.kurtosis - 1.8) < 0.02);
  CHECK(drawn.smallest >= -1.0);
  CHECK(drawn.largest < 1.0);
  CHECK(test::chi_square(test::histogram(weights, -1.0, 1.0, 20)) < 50.0);  // 19 degrees of freedom: p = 1e-4
}

TEST_CASE("uniform weights: another limit, or 0 -> as set") {
  std::vector<double> weights(10'000);
  Rng rng{15, Stream::initial_genome};
  UniformWeights{{.limit = 0.25}}.draw(weights, rng);
  CHECK(test::moments(weights).largest == doctest::Approx(0.25).epsilon(0.01));
  CHECK(test::moments(weights).smallest == doctest::Approx(-0.25).epsilon(0.01));
  UniformWeights{{.limit = 0.0}}.draw(weights, rng);
  CHECK(weights == std::vector<double>(10'000, 0.0));
}
