// SPDX-License-Identifier: MIT
// The paper's brain, with biases and without.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <trophic/control/brain/cognitive_brain.hpp>
#include <trophic/control/brain/cognitive_brain_with_biases.hpp>
#include <trophic/control/brain/cognitive_brain_zero_right.hpp>
#include <trophic/support/rng.hpp>
#include <unit/brain/check_out.hpp>
#include <vector>

using namespace trophic;
using control::brain::CognitiveBrain;
using control::brain::CognitiveBrainWithBiases;
using control::brain::CognitiveBrainZeroRight;

namespace {

/// A genome of zeros but for these weights.
template <class Brain = CognitiveBrain>
std::vector<double> genome(std::initializer_list<std::pair<std::size_t, double>> weights) {
  std::vector<double> result(Brain{}.genome_size(3, 2), 0.0);
  for (const auto& [index, weight] : weights) result.at(index) = weight;
  return result;
}

/// Positions in a genome.
constexpr std::size_t hidden_bias = 9;
constexpr std::size_t output_bias = 18;
template <class Brain>
constexpr std::size_t output_weight = std::is_same_v<Brain, CognitiveBrain> ? 9 : 12;

constexpr std::array nothing{0.0, 0.0, 0.0};

/// Weights of three inputs, two hidden neurons and both outputs.
template <class Brain>
std::vector<double> by_hand() {
  constexpr std::size_t out = output_weight<Brain>;
  return genome<Brain>({{0, 1.0}, {1, 0.5}, {7, -1.0}, {out, 0.5}, {out + 2, -1.0}, {out + 3, 1.0}, {out + 5, 2.0}});
}

}  // namespace

TEST_CASE("cognitive brain: 3-3-2 -> 15 weights or 20 with biases, three more per input, two tags") {
  CHECK(CognitiveBrain{}.genome_size(3, 2) == 15);
  CHECK(CognitiveBrain{}.genome_size(5, 2) == 21);
  CHECK(CognitiveBrainWithBiases{}.genome_size(3, 2) == 20);
  CHECK(CognitiveBrain{}.tags() == std::vector<int>{-1, 1});
}

TEST_CASE_TEMPLATE("cognitive brain: genome layout -> position of each weight", Brain, CognitiveBrain, CognitiveBrainWithBiases) {
  const Brain brain;
  const std::array inputs{-1.0, 0.25, 0.5};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const auto out = test::outputs(
          brain, inputs,
          genome<Brain>({{3 * row + column, 0.8}, {output_weight<Brain> + row, 1.0}, {output_weight<Brain> + 3 + row, -2.0}}));
      const double hidden = std::tanh(0.8 * inputs[column]);
      CHECK(out[0] == doctest::Approx(std::tanh(hidden)).epsilon(1e-15));
      CHECK(out[1] == doctest::Approx(std::tanh(-2.0 * hidden)).epsilon(1e-15));
    }
  }
}

TEST_CASE("cognitive brain with biases: genome layout -> position of each bias") {
  using Brain = CognitiveBrainWithBiases;
  for (std::size_t row = 0; row < 3; ++row) {
    const auto out =
        test::outputs(Brain{}, nothing, genome<Brain>({{hidden_bias + row, 0.3}, {output_weight<Brain> + row, 1.0}}));
    CHECK(out[0] == doctest::Approx(std::tanh(std::tanh(0.3))).epsilon(1e-15));
    CHECK(out[1] == 0.0);
  }
  const auto out = test::outputs(Brain{}, nothing, genome<Brain>({{output_bias, 0.4}, {output_bias + 1, -0.6}}));
  CHECK(out[0] == doctest::Approx(std::tanh(0.4)).epsilon(1e-15));
  CHECK(out[1] == doctest::Approx(std::tanh(-0.6)).epsilon(1e-15));
}

TEST_CASE("cognitive brain: network computed by hand -> same outputs") {
  const std::array inputs{1.0, 0.2, -0.5};
  // hidden = tanh(1 * 1 + 0.5 * 0.2, 0, -1 * 0.2) = tanh(1.1, 0, -0.2); out = tanh(0.5 h0 - h2, h0 + 2 h2)
  const auto out = test::outputs(CognitiveBrain{}, inputs, by_hand<CognitiveBrain>());
  CHECK(out[0] == doctest::Approx(0.5353572942).epsilon(1e-9));
  CHECK(out[1] == doctest::Approx(0.3848567272).epsilon(1e-9));
  // hidden = tanh(1 * 1 + 0.5 * 0.2 + 0.1, 0, -1 * 0.2) = tanh(1.2, 0, -0.2); out = tanh(0.5 h0 - h2 - 0.1, h0 + 2 h2 + 0)
  auto weights = by_hand<CognitiveBrainWithBiases>();
  weights[hidden_bias] = 0.1;
  weights[output_bias] = -0.1;
  const auto biased = test::outputs(CognitiveBrainWithBiases{}, inputs, weights);
  CHECK(biased[0] == doctest::Approx(0.4732132060).epsilon(1e-9));
  CHECK(biased[1] == doctest::Approx(0.4127355303).epsilon(1e-9));
}

TEST_CASE_TEMPLATE("cognitive brain: signs of the outputs -> target angle and tag", Brain, CognitiveBrain,
                   CognitiveBrainWithBiases) {
  const auto decide = [](double angle_weight, double tag_weight) {
    return test::decide(Brain{}, std::array{1.0, 0.0, 0.0},
                        genome<Brain>({{0, 1.0}, {output_weight<Brain>, angle_weight}, {output_weight<Brain> + 3, tag_weight}}));
  };
  CHECK(decide(0.1, 0.1).target_angle_rad == 0.7);
  CHECK(decide(0.1, 0.1).tag == 1);
  CHECK(decide(-0.1, 0.1).target_angle_rad == -0.7);
  CHECK(decide(-0.1, 0.1).tag == 1);
  CHECK(decide(0.1, -1e-9).target_angle_rad == 0.7);
  CHECK(decide(0.1, -1e-9).tag == -1);
}

TEST_CASE("cognitive brain: outputs of 0 -> left turn, or right in the zero-right brain, and tag -1") {
  using Biased = CognitiveBrainZeroRight::WithBiases;
  CHECK(test::decide(CognitiveBrain{}, nothing, genome({{0, 1.0}, {9, 1.0}})).target_angle_rad == -0.7);
  CHECK(test::decide(CognitiveBrainZeroRight{}, nothing, genome({})).target_angle_rad == 0.7);
  CHECK(test::decide(CognitiveBrainWithBiases{}, nothing, genome<Biased>({})).target_angle_rad == -0.7);
  CHECK(test::decide(Biased{}, nothing, genome<Biased>({})).target_angle_rad == 0.7);
  CHECK(test::decide(Biased{}, nothing, genome<Biased>({{output_bias, -1e-9}})).target_angle_rad == -0.7);
  CHECK(test::decide(CognitiveBrain{}, nothing, genome({})).tag == -1);
  CHECK(test::decide(CognitiveBrainZeroRight{}, nothing, genome({})).tag == -1);
  CHECK(test::decide(CognitiveBrainWithBiases{}, nothing, genome<Biased>({})).tag == -1);
  CHECK(test::decide(Biased{}, nothing, genome<Biased>({})).tag == -1);
}

TEST_CASE("cognitive brain with biases: another turn angle -> target angles of that size") {
  using Brain = CognitiveBrainWithBiases;
  const Brain brain{{.turn_angle_rad = 0.2}};
  CHECK(test::decide(brain, nothing, genome<Brain>({{output_bias, 1.0}})).target_angle_rad == 0.2);
  CHECK(test::decide(brain, nothing, genome<Brain>({{output_bias, -1.0}})).target_angle_rad == -0.2);
}

TEST_CASE_TEMPLATE("cognitive brain: opposite inputs and biases -> opposite outputs within +-1", Brain, CognitiveBrain,
                   CognitiveBrainWithBiases) {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    std::vector<double> weights(Brain{}.genome_size(3, 2));
    for (double& weight : weights) weight = rng.uniform(-3.0, 3.0);
    const std::array inputs{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.5, 0.5)};
    const auto out = test::outputs(Brain{}, inputs, weights);
    RC_ASSERT((std::abs(out[0]) <= 1.0 && std::abs(out[1]) <= 1.0));
    if (std::is_same_v<Brain, CognitiveBrainWithBiases>)
      for (std::size_t i : {hidden_bias, hidden_bias + 1, hidden_bias + 2, output_bias, output_bias + 1})
        weights[i] = -weights[i];
    const auto mirrored = test::outputs(Brain{}, std::array{-inputs[0], -inputs[1], -inputs[2]}, weights);
    RC_ASSERT((mirrored[0] == -out[0] && mirrored[1] == -out[1]));
  }));
}

TEST_CASE("cognitive brain: four brains -> four distinct names, a source each") {
  CHECK(CognitiveBrain::name == "cognitive_brain");
  CHECK(CognitiveBrainZeroRight::name == "cognitive_brain_zero_right");
  CHECK(CognitiveBrain::WithBiases::name == "cognitive_brain_with_biases");
  CHECK(CognitiveBrainZeroRight::WithBiases::name == "cognitive_brain_zero_right_with_biases");
  CHECK(CognitiveBrain::source.starts_with("paper, Sec. \"Cognitive Brain\""));
  CHECK(CognitiveBrainZeroRight::source == "released code");
  CHECK(CognitiveBrain::WithBiases::source == "not in the paper");
}
