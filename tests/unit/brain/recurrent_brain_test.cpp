// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/control/brain/recurrent_brain.hpp>
#include <trophic/support/rng.hpp>
#include <unit/brain/check_out.hpp>
#include <vector>

using namespace trophic;
using control::brain::FeedForwardBrain;
using control::brain::RecurrentBrain;

TEST_CASE("recurrent brain: two decisions -> the second remembers the first, computed by hand") {
  const RecurrentBrain brain{{.hidden = 1}};
  REQUIRE(brain.genome_size(1, 2) == 4);
  const std::vector<double> weights{0.5, -2.0, 1.5, -0.5};  // W1, R, W2
  RecurrentBrain::State own;
  const double first = std::tanh(0.5);
  check_out(test::outputs(brain, std::array{1.0}, weights, own), std::tanh(1.5 * first), std::tanh(-0.5 * first));
  CHECK((test::decide(brain, std::array{1.0}, weights, own) == control::Decision{.target_angle_rad = 0.7, .tag = -1}));
  REQUIRE(own.hidden == std::vector<double>{first});
  const double second = std::tanh(0.5 - 2.0 * first);
  check_out(test::outputs(brain, std::array{1.0}, weights, own), std::tanh(1.5 * second), std::tanh(-0.5 * second));
  CHECK((test::decide(brain, std::array{1.0}, weights, own) == control::Decision{.target_angle_rad = -0.7, .tag = 1}));
}

TEST_CASE("recurrent brain: no recurrent weights, or the first decision -> the feed-forward brain") {
  const RecurrentBrain brain{{.hidden = 4}};
  const FeedForwardBrain plain{{.hidden = 4}};
  Rng rng{3, Stream::user};
  std::vector<double> weights(brain.genome_size(3, 2));
  for (double& weight : weights) weight = rng.uniform(-2.0, 2.0);
  std::vector<double> layers(weights.begin(), weights.begin() + 12);
  layers.insert(layers.end(), weights.begin() + 28, weights.end());
  const std::array inputs{0.3, -0.8, 0.1};
  CHECK(test::outputs(brain, inputs, weights, {}) == test::outputs(plain, inputs, layers));
  std::fill(weights.begin() + 12, weights.begin() + 28, 0.0);
  RecurrentBrain::State own;
  for (int i = 0; i < 5; ++i) {
    CHECK(test::outputs(brain, inputs, weights, own) == test::outputs(plain, inputs, layers));
    static_cast<void>(test::decide(brain, inputs, weights, own));
  }
}

TEST_CASE("recurrent brain: birth -> nothing remembered") {
  const RecurrentBrain brain;
  const RecurrentBrain::State full{.hidden = {1.0, 2.0, 3.0}};
  CHECK(brain.born({}, &full, full).hidden.empty());
}

TEST_CASE("recurrent brain: links -> every weight once, with last tick's neuron before a recurrent one") {
  const RecurrentBrain brain{{.hidden = 2}};
  std::vector<double> weights(brain.genome_size(2, 2));
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = 0.1 * static_cast<double>(i) - 0.5;
  const RecurrentBrain::State own{.hidden = {0.25, -0.75}};
  const std::array inputs{1.0, -0.5};
  std::array<double, 4> sums{};  // hidden 0, hidden 1, outputs
  std::array<double, 4> seen{};
  std::size_t count = 0;
  brain.for_each_link(inputs, weights, own, [&](std::size_t weight, double before, double after) {
    const std::size_t neuron = weight < 8 ? weight % 4 / 2 : weight / 2 - 2;
    sums.at(neuron) += weights[weight] * before;
    seen.at(neuron) = after;
    if (weight >= 4 && weight < 8) CHECK(before == own.hidden[weight % 2]);
    ++count;
  });
  CHECK(count == weights.size());
  for (std::size_t i = 0; i < 4; ++i) CHECK(seen.at(i) == doctest::Approx(std::tanh(sums.at(i))).epsilon(1e-14));
}
