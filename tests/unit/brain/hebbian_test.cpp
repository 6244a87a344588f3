// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/control/brain/hebbian.hpp>
#include <trophic/control/brain/hebbian_brain.hpp>
#include <trophic/control/brain/recurrent_brain.hpp>
#include <trophic/support/rng.hpp>
#include <unit/brain/check_out.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::control::brain;

TEST_CASE("hebbian: feed-forward network of 3 hidden neurons -> the hebbian brain, bit by bit") {
  const Hebbian<FeedForwardBrain> learning{{.network = {}, .rate = 0.1}};
  const HebbianBrain known{{.rate = 0.1}};
  Rng rng{11, Stream::user};
  std::vector<double> weights(15);
  for (double& weight : weights) weight = rng.uniform(-2.0, 2.0);
  Hebbian<FeedForwardBrain>::State own;
  HebbianBrain::State other;
  for (int tick = 0; tick < 30; ++tick) {
    const std::array inputs{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    CHECK(test::outputs(learning, inputs, weights, own) == test::outputs(known, inputs, weights, other));
    CHECK((test::decide(learning, inputs, weights, own) == test::decide(known, inputs, weights, other)));
    CHECK(own.learnt == other.learnt);
  }
}

TEST_CASE("hebbian: growing network -> one step of Oja's rule on its weights, none on its structure") {
  const Hebbian<GrowingBrain> learning{{.network = {}, .rate = 0.1}};
  const std::vector<double> genes{1, 0, 2, 1, 3, 2, 4, 0.5, -1, 2};  // links 0 -> 2 -> 4 and 1 -> 3
  Hebbian<GrowingBrain>::State own;
  static_cast<void>(test::decide(learning, std::array{0.4, 0.3}, genes, own));
  const double hidden = std::tanh(0.5 * 0.4);
  const double out0 = std::tanh(-0.3);
  const double out1 = std::tanh(2.0 * hidden);
  REQUIRE(own.learnt.size() == genes.size());
  for (std::size_t i = 0; i < 7; ++i) CHECK(own.learnt[i] == 0.0);
  CHECK(own.learnt[7] == doctest::Approx(0.1 * hidden * (0.4 - hidden * 0.5)));
  CHECK(own.learnt[8] == doctest::Approx(0.1 * out0 * (0.3 - out0 * -1.0)));
  CHECK(own.learnt[9] == doctest::Approx(0.1 * out1 * (hidden - out1 * 2.0)));
}

TEST_CASE("hebbian: recurrent network -> learns and remembers") {
  const Hebbian<RecurrentBrain> learning{{.network = {.hidden = 1}, .rate = 0.1}};
  const std::vector<double> weights{0.5, -2.0, 1.5, -0.5};
  Hebbian<RecurrentBrain>::State own;
  static_cast<void>(test::decide(learning, std::array{1.0}, weights, own));
  const double first = std::tanh(0.5);
  CHECK(own.network.hidden == std::vector<double>{first});
  CHECK(own.learnt[0] == doctest::Approx(0.1 * first * (1.0 - first * 0.5)));
  CHECK(own.learnt[1] == doctest::Approx(0.1 * first * (0.0 - first * -2.0)));
  static_cast<void>(test::decide(learning, std::array{1.0}, weights, own));
  CHECK(own.network.hidden[0] ==
        doctest::Approx(std::tanh((0.5 + 0.1 * first * (1.0 - first * 0.5)) - (2.0 - 0.2 * first * first) * first)));
  CHECK(learning.born({}, &own, own).network.hidden.empty());
  CHECK(learning.born({}, &own, own).learnt.empty());
}

TEST_CASE("hebbian: names and numbers -> those of the network, nested") {
  CHECK(Hebbian<RecurrentBrain>::name == "hebbian_recurrent_brain");
  CHECK(Hebbian<FeedForwardBrain>{{.network = {.hidden = 5}}}.genome_size(3, 2) == 25);
}
