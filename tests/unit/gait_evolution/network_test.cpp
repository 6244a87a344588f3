// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <tools/gait_evolution/network.hpp>

namespace gait_evolution = trophic::gait_evolution;
using doctest::Approx;
using gait_evolution::Activation;
using gait_evolution::Genome;

TEST_CASE("each activation at hand-computed points") {
  CHECK(gait_evolution::activate(Activation::sine, 0.5) == Approx(0.479425538604203));
  CHECK(gait_evolution::activate(Activation::gaussian, 2.0) == Approx(0.0183156388887342));
  CHECK(gait_evolution::activate(Activation::tanh, 1.0) == Approx(0.761594155955765));
  CHECK(gait_evolution::activate(Activation::step, 0.0) == 1.0);
  CHECK(gait_evolution::activate(Activation::step, -1e-9) == 0.0);
  CHECK(gait_evolution::activate(Activation::linear, -3.5) == -3.5);
  CHECK(gait_evolution::activate(Activation::abs, -3.5) == 3.5);
  CHECK(gait_evolution::activate(Activation::linear, -1e300) == -1e6);
}

TEST_CASE("inputs are the constant and both cells, in this order") {
  Genome genome{.nodes = {{7, Activation::linear}}, .links = {}};
  for (std::uint32_t input = 0; input < 7; ++input) {
    genome.links.push_back({input, input, 7, std::pow(10.0, input), true});
  }
  CHECK(gait_evolution::Network{genome}({2, 3, 4}, {5, 6, 7}) == 7654321.0 - 6654321.0);  // the sum is clipped
  genome.links[6].enabled = false;
  CHECK(gait_evolution::Network{genome}({2, 3, 4}, {5, 6, 7}) == 654321.0);
}

TEST_CASE("network: any ids of hidden nodes -> computed before the nodes that they feed") {
  // x1 -> 9 (abs) -> 8 (linear) -> 7 (linear): |2 x1| * 3 * 0.5
  const Genome genome{.nodes = {{7, Activation::linear}, {8, Activation::linear}, {9, Activation::abs}},
                      .links = {{0, 8, 7, 0.5, true}, {1, 9, 8, 3.0, true}, {2, 1, 9, 2.0, true}}};
  CHECK(gait_evolution::Network{genome}({-4, 0, 0}, {0, 0, 0}) == 12.0);
}

TEST_CASE("the published CPPN gives the published weights of the spider's oscillators") {
  const double gain = 3.025;
  const Genome genome{.nodes = {{7, Activation::sine}},
                      .links = {{0, 0, 7, gain * 0.5193029403554234, true},
                                {1, 1, 7, gain * 0.0575994456677941, true},
                                {2, 2, 7, gain * 1.037920298210572, true},
                                {4, 4, 7, gain * 0.98193370804869985, true},
                                {5, 5, 7, gain * 0.9648602838256312, true},
                                {6, 6, 7, gain * 0.0636313795506953, true}}};
  const gait_evolution::Network network{genome};
  const Eigen::Vector3i front{1, 0, 0};
  const Eigen::Vector3i back{-1, 0, 0};
  const Eigen::Vector3i left{0, 1, 0};
  const Eigen::Vector3i right{0, -1, 0};
  const auto is = [](double expected) { return Approx(expected).epsilon(1e-4); };
  CHECK(network(front, front) == is(-1.0000));
  CHECK(network(back, back) == is(-1.0000));
  CHECK(network(left, left) == is(0.9749));
  CHECK(network(right, right) == is(0.9748));
  CHECK(network(front, back) == is(-0.9409));
  CHECK(network(front, left) == is(-0.9988));
  CHECK(network(front, right) == is(-0.9221));
  CHECK(network(back, left) == is(-0.9222));
  CHECK(network(back, right) == is(-0.9988));
  CHECK(network(left, right) == is(0.9757));
}
