// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/control/brain/hebbian.hpp>
#include <trophic/control/brain/recurrent_brain.hpp>
#include <unit/brain/check_out.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::control::brain;

TEST_CASE("hebbian: feed-forward network -> the network's first decision, then one step of Oja's rule, computed by hand") {
  const std::vector<double> weights{0.5, -0.3, 0.8, 0.1, 0.9, -0.7, -0.2, 0.4, 0.6, 0.3, -0.5, 0.7, -0.9, 0.2, 0.4};
  constexpr std::array inputs{1.0, 0.25, -0.5};
  const Hebbian<FeedForwardBrain> learning{{.network = {}, .rate = 0.1}};
  Hebbian<FeedForwardBrain>::State own;
  CHECK((test::decide(learning, inputs, weights, own) == test::decide(FeedForwardBrain{}, inputs, weights)));
  const double h0 = std::tanh(0.5 * 1.0 - 0.3 * 0.25 - 0.8 * 0.5);
  const double h1 = std::tanh(0.1 * 1.0 + 0.9 * 0.25 + 0.7 * 0.5);
  const double h2 = std::tanh(-0.2 * 1.0 + 0.4 * 0.25 - 0.6 * 0.5);
  const double out1 = std::tanh(-0.9 * h0 + 0.2 * h1 + 0.4 * h2);
  REQUIRE(own.learnt.size() == 15);
  CHECK(own.learnt[0] == doctest::Approx(0.1 * h0 * (1.0 - h0 * 0.5)));
  CHECK(own.learnt[5] == doctest::Approx(0.1 * h1 * (-0.5 - h1 * -0.7)));
  CHECK(own.learnt[13] == doctest::Approx(0.1 * out1 * (h1 - out1 * 0.2)));
  std::vector<double> sum = weights;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += own.learnt[i];
  CHECK(test::outputs(learning, inputs, weights, own) == test::outputs(FeedForwardBrain{}, inputs, sum));
  for (int i = 0; i < 20'000; ++i) static_cast<void>(test::decide(learning, std::array{i % 3 - 1.0, 0.3, 0.1}, weights, own));
  for (std::size_t i = 0; i < weights.size(); ++i) CHECK(std::abs(weights[i] + own.learnt[i]) < 3.0);
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
