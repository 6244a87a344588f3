// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/control/brain/cognitive_brain.hpp>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/support/rng.hpp>
#include <unit/brain/check_out.hpp>
#include <vector>

using namespace trophic;
using control::brain::FeedForwardBrain;

TEST_CASE("feed-forward brain: 3 hidden neurons -> the cognitive brain, bit by bit") {
  const control::brain::CognitiveBrain paper;
  const FeedForwardBrain brain;
  REQUIRE(brain.genome_size(3, 2) == paper.genome_size(3, 2));
  Rng rng{5, Stream::user};
  for (int i = 0; i < 50; ++i) {
    std::vector<double> weights(15);
    for (double& weight : weights) weight = rng.uniform(-3.0, 3.0);
    const std::array inputs{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    CHECK(test::outputs(brain, inputs, weights) == test::outputs(paper, inputs, weights));
    CHECK((test::decide(brain, inputs, weights) == test::decide(paper, inputs, weights)));
  }
}

TEST_CASE("feed-forward brain: one hidden neuron -> outputs computed by hand") {
  const FeedForwardBrain brain{{.hidden = 1, .turn_angle_rad = 0.2}};
  REQUIRE(brain.genome_size(2, 2) == 4);
  const std::vector<double> weights{0.5, -1.0, 2.0, -3.0};
  const std::array inputs{1.0, 0.25};
  const double hidden = std::tanh(0.5 - 0.25);
  check_out(test::outputs(brain, inputs, weights), std::tanh(2.0 * hidden), std::tanh(-3.0 * hidden));
  CHECK((test::decide(brain, inputs, weights) == control::Decision{.target_angle_rad = 0.2, .tag = -1}));
}

TEST_CASE("feed-forward brain: links -> every weight once, with the neurons at its ends") {
  const FeedForwardBrain brain{{.hidden = 2}};
  const std::vector<double> weights{0.5, -1.0, 2.0, -3.0, 0.1, 0.2, 0.3, 0.4};
  const std::array inputs{1.0, 0.25};
  std::array<double, 4> sums{};
  std::size_t next = 0;
  brain.for_each_link(inputs, weights, [&](std::size_t weight, double before, double after) {
    CHECK(weight == next++);
    const std::size_t neuron = weight / 2;
    sums.at(neuron) += weights[weight] * before;
    if (weight % 2 == 1) CHECK(after == std::tanh(sums.at(neuron)));
  });
  CHECK(next == 8);
}
