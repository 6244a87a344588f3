// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <limits>
#include <set>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/control/brain/hebbian.hpp>
#include <trophic/support/rng.hpp>
#include <unit/brain/check_out.hpp>
#include <vector>

using namespace trophic;
using control::brain::FeedForwardBrain;
using control::brain::GrowingBrain;

namespace {

using Genes = std::vector<double>;

/// A brain with one operator that always acts.
GrowingBrain only(double GrowingBrain::Params::*probability) {
  GrowingBrain::Params params{.add_link = 0, .remove_link = 0, .split_link = 0, .remove_neuron = 0};
  params.*probability = 1.0;
  return GrowingBrain{params};
}

/// All results of a brain's changes of a network of 2 inputs and 2 outputs, in 200 tries.
std::set<Genes> results(const GrowingBrain& brain, const Genes& parent) {
  std::set<Genes> found;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng{seed, Stream::user};
    Genes genes = parent;
    brain.mutate_structure(genes, 2, 2, rng);
    found.insert(genes);
  }
  return found;
}

/// Input 0 -> hidden neuron 2 (weight 0.5) -> output 4 (weight 2), input 1 -> output 3 (weight -1).
const Genes hand{1, 0, 2, 1, 3, 2, 4, 0.5, -1, 2};

}  // namespace

TEST_CASE("growing brain: hand-drawn network -> outputs computed by hand") {
  const GrowingBrain brain;
  REQUIRE(brain.fits(hand, 2, 2));
  check_out(test::outputs(brain, std::array{0.4, 0.3}, hand), std::tanh(-0.3), std::tanh(2 * std::tanh(0.2)));
  CHECK((test::decide(brain, std::array{0.4, 0.3}, hand) == control::Decision{.target_angle_rad = -0.7, .tag = 1}));
  CHECK(test::outputs(brain, std::array{0.4, 0.3}, Genes{0}) == std::array{0.0, 0.0});
}

TEST_CASE("growing brain: first genome -> the feed-forward brain's network, its weights in the same order") {
  Rng rng{2, Stream::user};
  const GrowingBrain brain{{.hidden = 4}};
  Genes genes = brain.first(3, 2, rng);
  REQUIRE(brain.fits(genes, 3, 2));
  const FeedForwardBrain plain{{.hidden = 4}};
  const std::span<double> weights = brain.weights_of(genes);
  REQUIRE(weights.size() == plain.genome_size(3, 2));
  for (double& weight : weights) weight = rng.uniform(-2.0, 2.0);
  const std::array inputs{0.3, -0.8, 0.1};
  CHECK(test::outputs(brain, inputs, genes) == test::outputs(plain, inputs, weights));
  Genes direct = GrowingBrain{{.hidden = 0}}.first(3, 2, rng);
  CHECK(direct == Genes{0, 0, 3, 1, 3, 2, 3, 0, 4, 1, 4, 2, 4, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("growing brain: operators -> every network that is possible, and no other") {
  CHECK(results(only(&GrowingBrain::Params::remove_link), hand) ==
        std::set<Genes>{{1, 1, 3, 2, 4, -1, 2}, {1, 0, 2, 2, 4, 0.5, 2}, {1, 0, 2, 1, 3, 0.5, -1}});
  CHECK(results(only(&GrowingBrain::Params::remove_neuron), hand) == std::set<Genes>{{0, 1, 2, -1}});
  CHECK(results(only(&GrowingBrain::Params::split_link), hand) == std::set<Genes>{{2, 0, 2, 2, 3, 1, 4, 3, 5, 1, 0.5, -1, 2},
                                                                                  {2, 0, 2, 1, 3, 3, 4, 2, 5, 0.5, 1, -1, 2},
                                                                                  {2, 0, 2, 2, 3, 1, 4, 3, 5, 0.5, 1, -1, 2}});
  std::set<std::pair<double, double>> added;
  for (const Genes& genes : results(only(&GrowingBrain::Params::add_link), hand)) {
    REQUIRE(genes.size() == hand.size() + 3);
    for (std::size_t link = 0; link < 4; ++link) added.insert({genes[1 + 2 * link], genes[2 + 2 * link]});
  }
  CHECK(added == std::set<std::pair<double, double>>{{0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {0, 4}, {1, 4}, {2, 4}});
}

TEST_CASE("growing brain: nothing possible -> genes unchanged") {
  CHECK(results(only(&GrowingBrain::Params::remove_link), {0}) == std::set<Genes>{{0}});
  CHECK(results(only(&GrowingBrain::Params::remove_neuron), {0, 0, 2, 0.5}) == std::set<Genes>{{0, 0, 2, 0.5}});
  GrowingBrain full = only(&GrowingBrain::Params::split_link);
  full.params.most_hidden = 1;
  CHECK(results(full, hand) == std::set<Genes>{hand});
}

TEST_CASE("growing brain: genes that are not a network -> do not fit") {
  const GrowingBrain brain;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Genes& genes : {Genes{}, Genes{31}, Genes{-1}, Genes{0.5}, Genes{nan}, Genes{0, 0, 2}, Genes{0, 0, 1, 0.5},
                             Genes{0, 2, 3, 0.5}, Genes{0, 0, 4, 0.5}, Genes{1, 2, 2, 0.5}, Genes{0, 0.5, 2, 0.5},
                             Genes{0, 0, 2, nan}, Genes{0, 0, 2, 0, 2, 0.5, 0.5}, Genes{0, 0, 3, 0, 2, 0.5, 0.5}}) {
    CAPTURE(genes.size());
    CHECK_FALSE(brain.fits(genes, 2, 2));
  }
  CHECK(brain.fits(Genes{0, 0, 2, 0.5}, 2, 2));
}

TEST_CASE("growing brain: any sequence of births -> networks that fit, weights that rules may change") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    const GrowingBrain brain{
        {.hidden = rng.index(4), .most_hidden = 6, .add_link = 0.5, .remove_link = 0.4, .split_link = 0.4, .remove_neuron = 0.2}};
    Genes genes = brain.first(3, 2, rng);
    for (int birth = 0; birth < 40; ++birth) {
      for (double& weight : brain.weights_of(genes)) weight += rng.normal(0.0, 0.3);
      brain.mutate_structure(genes, 3, 2, rng);
      RC_ASSERT(brain.fits(genes, 3, 2));
      const auto out = test::outputs(brain, std::array{0.5, -0.25, 1.0}, genes);
      RC_ASSERT((std::abs(out[0]) <= 1.0 && std::abs(out[1]) <= 1.0));
    }
  }));
}

TEST_CASE("growing brain: distance of two networks -> of their weights, links matched by their neurons") {
  const GrowingBrain brain;
  CHECK(brain.distance(hand, hand) == 0.0);
  CHECK(brain.distance(hand, Genes{1, 0, 2, 1, 3, 2, 4, 0.5, -1, 5}) == 3.0);
  CHECK(brain.distance(hand, Genes{1, 0, 2, 2, 4, 0.5, 2}) == 1.0);    // without 1 -> 3
  CHECK(brain.distance(hand, Genes{0, 1, 2, -1}) == std::sqrt(4.25));  // without neuron 2 and its links
  const Genes split{2, 0, 2, 2, 3, 1, 4, 3, 5, 1, 0.5, -1, 2};         // 0 -> 2 split: 0.5 becomes 1 and 0.5
  REQUIRE(brain.fits(split, 2, 2));
  CHECK(brain.distance(hand, split) == std::sqrt(1.5));
  CHECK(brain.distance(split, hand) == std::sqrt(1.5));
  CHECK(control::brain::Hebbian<GrowingBrain>{}.distance(hand, split) == std::sqrt(1.5));
}

TEST_CASE("growing brain: split link with a small input -> nearly the same output") {
  const GrowingBrain brain = only(&GrowingBrain::Params::split_link);
  const std::array inputs{0.01, 0.02};
  const auto before = test::outputs(brain, inputs, hand);
  for (const Genes& genes : results(brain, hand)) {
    const auto after = test::outputs(brain, inputs, genes);
    CHECK(after[0] == doctest::Approx(before[0]).epsilon(0.001));
    CHECK(after[1] == doctest::Approx(before[1]).epsilon(0.001));
  }
}
