// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <trophic/control/brain/cognitive_brain.hpp>
#include <trophic/control/brain/cognitive_brain_zero_right.hpp>
#include <trophic/support/rng.hpp>
#include <unit/brain/check_out.hpp>
#include <vector>

using namespace trophic;
using control::brain::CognitiveBrain;
using control::brain::CognitiveBrainZeroRight;

namespace {

/// A genome of zeros but for these weights.
std::vector<double> genome(std::initializer_list<std::pair<std::size_t, double>> weights) {
  std::vector<double> result(CognitiveBrain{}.genome_size(3, 2), 0.0);
  for (const auto& [index, weight] : weights) result.at(index) = weight;
  return result;
}

constexpr std::size_t output_weight = 9;

constexpr std::array nothing{0.0, 0.0, 0.0};

}  // namespace

TEST_CASE("cognitive brain: 3-3-2 without biases -> 15 weights, three more per input, two tags") {
  CHECK(CognitiveBrain{}.genome_size(3, 2) == 15);
  CHECK(CognitiveBrain{}.genome_size(5, 2) == 21);
  CHECK(CognitiveBrain{}.tags() == std::vector<int>{-1, 1});
}

TEST_CASE("cognitive brain: genome layout -> position of each weight") {
  const CognitiveBrain brain;
  const std::array inputs{-1.0, 0.25, 0.5};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const auto out = test::outputs(
          brain, inputs, genome({{3 * row + column, 0.8}, {output_weight + row, 1.0}, {output_weight + 3 + row, -2.0}}));
      const double hidden = std::tanh(0.8 * inputs[column]);
      CHECK(out[0] == doctest::Approx(std::tanh(hidden)).epsilon(1e-15));
      CHECK(out[1] == doctest::Approx(std::tanh(-2.0 * hidden)).epsilon(1e-15));
    }
  }
}

TEST_CASE("cognitive brain: network computed by hand -> same outputs") {
  // hidden = tanh(1 * 1 + 0.5 * 0.2, 0, -1 * 0.2) = tanh(1.1, 0, -0.2); out = tanh(0.5 h0 - h2, h0 + 2 h2)
  const auto weights = genome({{0, 1.0},
                               {1, 0.5},
                               {7, -1.0},
                               {output_weight, 0.5},
                               {output_weight + 2, -1.0},
                               {output_weight + 3, 1.0},
                               {output_weight + 5, 2.0}});
  const auto out = test::outputs(CognitiveBrain{}, std::array{1.0, 0.2, -0.5}, weights);
  CHECK(out[0] == doctest::Approx(0.5353572942).epsilon(1e-9));
  CHECK(out[1] == doctest::Approx(0.3848567272).epsilon(1e-9));
}

TEST_CASE("cognitive brain: signs of the outputs -> target angle and tag") {
  const CognitiveBrain brain;
  const auto decide = [&](double angle_weight, double tag_weight) {
    return test::decide(brain, std::array{1.0, 0.0, 0.0},
                        genome({{0, 1.0}, {output_weight, angle_weight}, {output_weight + 3, tag_weight}}));
  };
  CHECK(decide(0.1, 0.1).target_angle_rad == 0.7);
  CHECK(decide(0.1, 0.1).tag == 1);
  CHECK(decide(-0.1, 0.1).target_angle_rad == -0.7);
  CHECK(decide(-0.1, 0.1).tag == 1);
  CHECK(decide(0.1, -1e-9).target_angle_rad == 0.7);
  CHECK(decide(0.1, -1e-9).tag == -1);
}

TEST_CASE("cognitive brain: outputs of 0 -> left turn, or right in the zero-right brain, and tag -1") {
  CHECK(test::decide(CognitiveBrain{}, nothing, genome({{0, 1.0}, {output_weight, 1.0}})).target_angle_rad == -0.7);
  CHECK(test::decide(CognitiveBrainZeroRight{}, nothing, genome({})).target_angle_rad == 0.7);
  CHECK(test::decide(CognitiveBrain{}, nothing, genome({})).tag == -1);
  CHECK(test::decide(CognitiveBrainZeroRight{}, nothing, genome({})).tag == -1);
}

TEST_CASE("cognitive brain: inputs with opposite sign -> opposite turn") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    const CognitiveBrain brain;
    std::vector<double> weights(brain.genome_size(3, 2));
    for (double& weight : weights) weight = rng.uniform(-3.0, 3.0);
    const std::array inputs{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.5, 0.5)};
    const auto out = test::outputs(brain, inputs, weights);
    RC_ASSERT((std::abs(out[0]) <= 1.0 && std::abs(out[1]) <= 1.0));
    const auto mirrored = test::outputs(brain, std::array{-inputs[0], -inputs[1], -inputs[2]}, weights);
    RC_ASSERT((mirrored[0] == -out[0] && mirrored[1] == -out[1]));
  }));
}

TEST_CASE("cognitive brain: brain with biases -> same turn at zero, four distinct names") {
  CHECK(CognitiveBrain::name == "cognitive_brain");
  CHECK(CognitiveBrainZeroRight::name == "cognitive_brain_zero_right");
  CHECK(CognitiveBrain::WithBiases::name == "cognitive_brain_with_biases");
  CHECK(CognitiveBrainZeroRight::WithBiases::name == "cognitive_brain_zero_right_with_biases");
  CHECK(test::decide(CognitiveBrainZeroRight::WithBiases{}, nothing, std::vector<double>(20)).target_angle_rad == 0.7);
}
