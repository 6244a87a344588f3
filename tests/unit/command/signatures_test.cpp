// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <span>
#include <tools/experiment/signatures.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::command;

namespace {

using Weights = std::vector<double>;

/// Turns by the first input, shows a tag by the second, and eats if there is a third weight and it is positive.
std::vector<int> decide_by_weights(Species, std::span<const double> inputs, std::span<const double> weights) {
  const double turn = weights[0] * inputs[0];
  std::vector<int> acts{(turn > 0.0 ? 1 : 0) - (turn < 0.0 ? 1 : 0), weights[1] * inputs[1] > 0.0 ? 1 : -1};
  if (weights.size() > 2) acts.push_back(weights[2] * inputs[0] > 0.0 ? 1 : -1);
  return acts;
}

}  // namespace

TEST_CASE("signatures: same acts at all inputs -> one type, another species or act -> another") {
  Signatures signatures{decide_by_weights, {{{-1.0, 1.0}, {1.0, 0.5}}, {{1.0, 1.0}}}};
  const Type type = signatures.type_of(0, Weights{1.0, 1.0});
  CHECK(signatures.type_of(0, Weights{2.0, 0.1}) == type);
  CHECK(signatures.type_of(0, Weights{-1.0, 1.0}) != type);
  CHECK(signatures.type_of(0, Weights{1.0, -1.0}) != type);
  CHECK(signatures.type_of(0, Weights{0.0, 1.0}) != type);
  CHECK(signatures.type_of(1, Weights{1.0, 1.0}) != type);
  CHECK(signatures.type_of(0, Weights{1.0, 1.0, 1.0}) != signatures.type_of(0, Weights{1.0, 1.0, -1.0}));
}

TEST_CASE("signatures: complexity -> pairs of an input and an act that depend on each other") {
  const Signatures signatures{decide_by_weights, {{{-1.0, 1.0}, {1.0, 0.5}}, {{-1.0, 1.0}, {1.0, -1.0}}, {}}};
  CHECK(signatures.complexity(0, Weights{1.0, 1.0}) == 1);  // the second input is always positive
  CHECK(signatures.complexity(1, Weights{1.0, 1.0}) == 2);
  CHECK(signatures.complexity(1, Weights{0.0, 1.0}) == 1);
  CHECK(signatures.complexity(1, Weights{0.0, 0.0}) == 0);
  CHECK(signatures.complexity(2, Weights{1.0, 1.0}) == 0);
  CHECK(signatures.complexity(0, Weights{1.0, 1.0, 1.0}) == 2);
}
