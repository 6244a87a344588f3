// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <trophic/control/brain/cognitive_brain_with_biases.hpp>
#include <trophic/control/brain/cognitive_brain_zero_right.hpp>
#include <trophic/support/rng.hpp>
#include <unit/brain/check_out.hpp>
#include <vector>

using namespace trophic;
using control::brain::CognitiveBrainWithBiases;
using control::brain::CognitiveBrainZeroRight;

namespace {

/// A genome of zeros but for these weights.
std::vector<double> biased_genome(std::initializer_list<std::pair<std::size_t, double>> weights) {
  std::vector<double> result(CognitiveBrainWithBiases{}.genome_size(3, 2), 0.0);
  for (const auto& [index, weight] : weights) result.at(index) = weight;
  return result;
}

constexpr std::size_t hidden_bias = 9;
constexpr std::size_t weight_after_biases = 12;
constexpr std::size_t output_bias = 18;

constexpr std::array no_inputs{0.0, 0.0, 0.0};

}  // namespace

TEST_CASE("cognitive brain with biases: 3-3-2 -> 20 weights") {
  CHECK(CognitiveBrainWithBiases{}.genome_size(3, 2) == 20);
}

TEST_CASE("cognitive brain with biases: genome layout -> position of each weight") {
  const CognitiveBrainWithBiases brain;
  const std::array inputs{-1.0, 0.25, 0.5};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const auto out = test::outputs(
          brain, inputs,
          biased_genome({{3 * row + column, 0.8}, {weight_after_biases + row, 1.0}, {weight_after_biases + 3 + row, -2.0}}));
      const double hidden = std::tanh(0.8 * inputs[column]);
      CHECK(out[0] == doctest::Approx(std::tanh(hidden)).epsilon(1e-15));
      CHECK(out[1] == doctest::Approx(std::tanh(-2.0 * hidden)).epsilon(1e-15));
    }
    const auto out = test::outputs(brain, inputs, biased_genome({{hidden_bias + row, 0.3}, {weight_after_biases + row, 1.0}}));
    CHECK(out[0] == doctest::Approx(std::tanh(std::tanh(0.3))).epsilon(1e-15));
    CHECK(out[1] == 0.0);
  }
  const auto out = test::outputs(brain, inputs, biased_genome({{output_bias, 0.4}, {output_bias + 1, -0.6}}));
  CHECK(out[0] == doctest::Approx(std::tanh(0.4)).epsilon(1e-15));
  CHECK(out[1] == doctest::Approx(std::tanh(-0.6)).epsilon(1e-15));
}

TEST_CASE("cognitive brain with biases: network computed by hand -> same outputs") {
  // hidden = tanh(1 * 1 + 0.5 * 0.2 + 0.1, 0, -1 * 0.2) = tanh(1.2, 0, -0.2); out = tanh(0.5 h0 - h2 - 0.1, h0 + 2 h2 + 0)
  const auto weights = biased_genome({{0, 1.0},
                                      {1, 0.5},
                                      {hidden_bias, 0.1},
                                      {7, -1.0},
                                      {weight_after_biases, 0.5},
                                      {weight_after_biases + 2, -1.0},
                                      {output_bias, -0.1},
                                      {weight_after_biases + 3, 1.0},
                                      {weight_after_biases + 5, 2.0}});
  const auto out = test::outputs(CognitiveBrainWithBiases{}, std::array{1.0, 0.2, -0.5}, weights);
  CHECK(out[0] == doctest::Approx(0.4732132060).epsilon(1e-9));
  CHECK(out[1] == doctest::Approx(0.4127355303).epsilon(1e-9));
}

TEST_CASE("cognitive brain with biases: signs of the outputs -> target angle and tag") {
  const CognitiveBrainWithBiases brain;
  const auto decide = [&](double angle_output, double tag_output) {
    return test::decide(brain, no_inputs, biased_genome({{output_bias, angle_output}, {output_bias + 1, tag_output}}));
  };
  CHECK(decide(0.1, 0.1).target_angle_rad == 0.7);
  CHECK(decide(0.1, 0.1).tag == 1);
  CHECK(decide(-0.1, 0.1).target_angle_rad == -0.7);
  CHECK(decide(-0.1, 0.1).tag == 1);
  CHECK(decide(0.1, -1e-9).target_angle_rad == 0.7);
  CHECK(decide(0.1, -1e-9).tag == -1);
}

TEST_CASE(
    "cognitive brain with biases: an angle output of 0 turns left, or right where it counts as positive, a tag output of 0 shows "
    "-1") {
  CHECK(test::decide(CognitiveBrainWithBiases{}, no_inputs, biased_genome({})).target_angle_rad == -0.7);
  CHECK(test::decide(CognitiveBrainZeroRight::WithBiases{}, no_inputs, biased_genome({})).target_angle_rad == 0.7);
  CHECK(test::decide(CognitiveBrainZeroRight::WithBiases{}, no_inputs, biased_genome({{output_bias, -1e-9}})).target_angle_rad ==
        -0.7);
  CHECK(test::decide(CognitiveBrainWithBiases{}, no_inputs, biased_genome({})).tag == -1);
  CHECK(test::decide(CognitiveBrainZeroRight::WithBiases{}, no_inputs, biased_genome({})).tag == -1);
}

TEST_CASE("cognitive brain with biases: another turn angle -> target angles of that size") {
  const CognitiveBrainWithBiases brain{{.turn_angle_rad = 0.2}};
  CHECK(test::decide(brain, no_inputs, biased_genome({{output_bias, 1.0}})).target_angle_rad == 0.2);
  CHECK(test::decide(brain, no_inputs, biased_genome({{output_bias, -1.0}})).target_angle_rad == -0.2);
}

TEST_CASE("cognitive brain with biases: any inputs -> outputs within +-1, odd if biases change sign too") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    const CognitiveBrainWithBiases brain;
    std::vector<double> weights(brain.genome_size(3, 2));
    for (double& weight : weights) weight = rng.uniform(-3.0, 3.0);
    const std::array inputs{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.5, 0.5)};
    const auto out = test::outputs(brain, inputs, weights);
    RC_ASSERT((std::abs(out[0]) <= 1.0 && std::abs(out[1]) <= 1.0));
    // mirrored inputs with mirrored biases give mirrored outputs
    for (std::size_t i : {hidden_bias, hidden_bias + 1, hidden_bias + 2, output_bias, output_bias + 1}) weights[i] = -weights[i];
    const auto mirrored = test::outputs(brain, std::array{-inputs[0], -inputs[1], -inputs[2]}, weights);
    RC_ASSERT((mirrored[0] == -out[0] && mirrored[1] == -out[1]));
  }));
}
