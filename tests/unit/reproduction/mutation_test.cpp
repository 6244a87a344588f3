// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <cmath>
#include <cstdint>
#include <support/statistics.hpp>
#include <trophic/reproduction/mutation/no_mutation.hpp>
#include <trophic/reproduction/mutation/normal_mutation.hpp>
#include <trophic/reproduction/mutation/uniform_mutation.hpp>
#include <vector>

using namespace trophic;
using reproduction::mutation::NormalMutation;
using reproduction::mutation::UniformMutation;

TEST_CASE("no mutation: any genome -> weights unchanged, no draws") {
  std::vector<double> weights{0.5, -1.0, 7.0};
  Rng rng{1, Stream::mutation};
  Rng reference = rng;
  reproduction::mutation::NoMutation{}.mutate(weights, Individual{}, rng);
  CHECK(weights == std::vector<double>{0.5, -1.0, 7.0});
  CHECK(rng.bits() == reference.bits());
}

TEST_CASE("normal mutation: many steps -> normal with mean 0 and the given sd for every weight") {
  constexpr std::size_t offspring = 10'000;
  const std::vector<double> parent{0.0, 0.9, -3.0, 0.5, 1.0, -1.0, 0.1, 0.2, 0.3, 0.4,
                                   0.5, 0.6, 0.7,  0.8, 0.9, -0.1, 0.0, 0.0, 0.0, 0.0};
  for (const double sd : {0.05, 0.3}) {
    std::vector<double> steps;
    std::vector<double> steps_of_third;
    for (std::size_t i = 0; i < offspring; ++i) {
      Rng rng{11, Stream::mutation, i};
      std::vector<double> weights = parent;
      NormalMutation{{.sd = sd}}.mutate(weights, Individual{}, rng);
      for (std::size_t w = 0; w < parent.size(); ++w) steps.push_back(weights[w] - parent[w]);
      steps_of_third.push_back(weights[2] - parent[2]);
    }
    const double size = 200'000.0;
    const test::Moments all = test::moments(steps);
    CHECK(std::abs(all.mean) < 4.0 * sd / std::sqrt(size));
    CHECK(std::abs(all.sd / sd - 1.0) < 4.0 / std::sqrt(2.0 * size));
    CHECK(std::abs(all.skewness) < 4.0 * std::sqrt(6.0 / size));
    CHECK(std::abs(all.kurtosis - 3.0) < 4.0 * std::sqrt(24.0 / size));
    CHECK(all.largest > 3.5 * sd);
    const test::Moments third = test::moments(steps_of_third);
    CHECK(std::abs(third.mean) < 4.0 * sd / 100.0);
    CHECK(std::abs(third.sd / sd - 1.0) < 4.0 / std::sqrt(2.0 * 10'000.0));
  }
}

TEST_CASE("normal mutation: large weights -> not clipped, sd 0 -> unchanged, no weights -> no draws") {
  std::vector<double> weights(1000, 1.0);
  Rng rng{1, Stream::mutation};
  NormalMutation{}.mutate(weights, Individual{}, rng);
  CHECK(test::moments(weights).largest > 1.1);
  std::vector<double> still{0.5, -2.0};
  NormalMutation{{.sd = 0.0}}.mutate(still, Individual{}, rng);
  CHECK(still == std::vector<double>{0.5, -2.0});
  Rng untouched = rng;
  NormalMutation{}.mutate({}, Individual{}, rng);
  CHECK(rng.bits() == untouched.bits());
}

TEST_CASE("normal mutation: weights -> each plus its own draw, in order") {
  std::vector<double> weights{0.5, -2.0, 0.0};
  Rng rng{3, Stream::mutation};
  Rng draws = rng;
  NormalMutation{{.sd = 0.2}}.mutate(weights, Individual{}, rng);
  std::vector<double> expected{0.5, -2.0, 0.0};
  for (double& weight : expected) weight += draws.normal(0.0, 0.2);
  CHECK(weights == expected);
}

TEST_CASE("uniform mutation: many steps -> uniform within +-half width") {
  std::vector<double> weights(200'000, 0.0);
  Rng rng{12, Stream::mutation};
  UniformMutation{}.mutate(weights, Individual{}, rng);
  const test::Moments steps = test::moments(weights);
  const double sd = 0.1 / std::sqrt(12.0);
  const double size = 200'000.0;
  CHECK(std::abs(steps.mean) < 4.0 * sd / std::sqrt(size));
  CHECK(std::abs(steps.sd / sd - 1.0) < 4.0 * std::sqrt(0.8 / (4.0 * size)));
  CHECK(std::abs(steps.kurtosis - 1.8) < 0.02);
  CHECK(steps.smallest >= -0.05);
  CHECK(steps.largest < 0.05);
  CHECK(test::chi_square(test::histogram(weights, -0.05, 0.05, 20)) < 50.0);  // 19 degrees of freedom: p = 1e-4
}

TEST_CASE("uniform mutation: weight at the limit -> stays there half of the time") {
  std::vector<double> weights(100'000, 1.0);
  Rng rng{13, Stream::mutation};
  UniformMutation{}.mutate(weights, Individual{}, rng);
  std::size_t at_limit = 0;
  for (const double weight : weights) {
    REQUIRE(weight <= 1.0);
    if (weight == 1.0) ++at_limit;
  }
  CHECK(static_cast<double>(at_limit) == doctest::Approx(50'000.0).epsilon(4.0 / 316.0));
}

TEST_CASE("uniform mutation: any weights -> steps within half width, weights within limits") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    const UniformMutation rule{{.half_width = rng.uniform(0.0, 0.5), .limit = rng.uniform(0.1, 2.0)}};
    std::vector<double> weights(20);
    for (double& weight : weights) weight = rng.uniform(-rule.params.limit, rule.params.limit);
    const std::vector<double> before = weights;
    rule.mutate(weights, Individual{}, rng);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      RC_ASSERT(std::abs(weights[i]) <= rule.params.limit);
      RC_ASSERT(std::abs(weights[i] - before[i]) <= rule.params.half_width + 1e-15);
    }
  }));
}

TEST_CASE("uniform mutation: weights -> each plus its own draw, in order") {
  std::vector<double> weights{0.5, -0.5, 0.0};
  Rng rng{3, Stream::mutation};
  Rng draws = rng;
  UniformMutation{{.half_width = 0.2}}.mutate(weights, Individual{}, rng);
  std::vector<double> expected{0.5, -0.5, 0.0};
  for (double& weight : expected) weight += draws.uniform(-0.2, 0.2);
  CHECK(weights == expected);
}
