// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <tools/analysis/metrics/tag_symmetry.hpp>
#include <unit/reading/rows.hpp>
#include <utility>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::test;
using analysis::AgentRow;
using analysis::bernoulli_symmetry;
using analysis::permuted_symmetry;
using analysis::tag_symmetry;

AgentRow tagged(std::int64_t tick, IndividualId id, Species species, int tag, Origin origin = Origin::inherited) {
  return robot(tick, id, species, 0.0, 0.0, {}, origin, tag);
}

}  // namespace

TEST_CASE("tag symmetry is |sum of the mean tags| of the inherited") {
  const std::vector<AgentRow> agents{
      tagged(1, 0, prey, 1),      tagged(1, 1, prey, 1),      tagged(1, 2, prey, -1, Origin::random),
      tagged(1, 3, predator, -1), tagged(1, 4, predator, -1), tagged(1, 5, predator, 1),  // |1 - 1/3|
      tagged(2, 0, prey, -1),     tagged(2, 3, predator, -1)                              // |-2|
  };
  const auto symmetry = tag_symmetry(agents, prey, predator);
  CHECK(*symmetry.observed.mean() == doctest::Approx((2.0 / 3.0 + 2.0) / 2.0));
  // 3 of 5 positive, then none of 2
  CHECK(*symmetry.permuted.mean() == doctest::Approx((permuted_symmetry(2, 3, 3) + 2.0) / 2.0));
  CHECK(*symmetry.bernoulli_tags.mean() == doctest::Approx((bernoulli_symmetry(2, 3) + bernoulli_symmetry(1, 1)) / 2.0));
}

TEST_CASE("tag symmetry: inactive or random members -> not in group inherited_active") {
  std::vector<AgentRow> agents{tagged(1, 0, prey, 1), tagged(1, 1, prey, -1), tagged(1, 2, prey, -1, Origin::random),
                               tagged(1, 3, predator, -1)};
  agents[1].active = false;
  CHECK(*tag_symmetry(agents, prey, predator).observed.mean() == 1.0);
  CHECK(*tag_symmetry(agents, prey, predator, analysis::Group::inherited_active).observed.mean() == 0.0);
}

TEST_CASE("a species with no inherited member leaves the tick out, or the whole run") {
  const std::vector<AgentRow> agents{tagged(1, 0, prey, 1), tagged(1, 1, predator, 1, Origin::random), tagged(2, 0, prey, 1),
                                     tagged(2, 1, predator, -1)};
  CHECK(*tag_symmetry(agents, prey, predator).observed.mean() == 0.0);
  const std::vector<AgentRow> first{agents[0], agents[1]};
  CHECK_FALSE(tag_symmetry(first, prey, predator).observed.mean());
  CHECK_FALSE(tag_symmetry(first, prey, predator).bernoulli_tags.mean());
  CHECK_FALSE(tag_symmetry({}, prey, predator).observed.mean());
}

TEST_CASE("permuted tags: small cases by hand") {
  CHECK(permuted_symmetry(1, 1, 1) == doctest::Approx(0.0));
  CHECK(permuted_symmetry(1, 1, 2) == doctest::Approx(2.0));
  CHECK(permuted_symmetry(3, 4, 0) == doctest::Approx(2.0));
  CHECK(permuted_symmetry(1, 2, 1) == doctest::Approx((1.0 * 0.0 + 2.0 * 1.0) / 3.0));  // |1 - 1| or |-1 + 0|
  CHECK(permuted_symmetry(9, 21, 13) == doctest::Approx(permuted_symmetry(21, 9, 13)));
  CHECK(permuted_symmetry(9, 21, 13) == doctest::Approx(permuted_symmetry(9, 21, 17)));  // the other tag
}

TEST_CASE("permuted tags: common bias -> kept, and over all numbers of positive tags the mean of Bernoulli(1/2) tags") {
  CHECK(permuted_symmetry(10, 10, 19) > 1.7);
  double expectation = 0.0;
  for (std::size_t plus = 0; plus <= 12; ++plus) {
    const auto k = static_cast<double>(plus);
    const double probability =
        std::exp(std::lgamma(13.0) - std::lgamma(k + 1.0) - std::lgamma(13.0 - k) - 12.0 * std::numbers::ln2);
    expectation += probability * permuted_symmetry(5, 7, plus);
  }
  CHECK(expectation == doctest::Approx(bernoulli_symmetry(5, 7)));
}

TEST_CASE("permuted tags: exact value -> that of shuffled tags") {
  Rng rng{8, Stream::null_model};
  std::vector<int> deck{1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1};
  analysis::Mean sampled;
  for (int trial = 0; trial < 50'000; ++trial) {
    for (std::size_t i = deck.size(); i > 1; --i) std::swap(deck[i - 1], deck[rng.index(i)]);
    double first = 0.0;
    double second = 0.0;
    for (std::size_t i = 0; i < deck.size(); ++i) (i < 4 ? first : second) += deck[i];
    sampled.add(std::abs(first / 4.0 + second / 7.0));
  }
  CHECK(*sampled.value() == doctest::Approx(permuted_symmetry(4, 7, 7)).epsilon(0.01));
}

TEST_CASE("Bernoulli tags: small cases by hand") {
  CHECK(bernoulli_symmetry(1, 1) == doctest::Approx(1.0));   // 2, 0, 0, 2
  CHECK(bernoulli_symmetry(1, 2) == doctest::Approx(1.0));   // |1 + {1, 0, 0, -1}| = 2, 1, 1, 0
  CHECK(bernoulli_symmetry(2, 2) == doctest::Approx(0.75));  // sums of two of {1, 0, 0, -1}: 2/16*2 + 8/16*1
  CHECK(bernoulli_symmetry(9, 21) == doctest::Approx(bernoulli_symmetry(21, 9)));
}

TEST_CASE("Bernoulli tags: numbers of a whole population -> about 0.32") {
  CHECK(bernoulli_symmetry(9, 21) == doctest::Approx(0.32).epsilon(0.01));
}

TEST_CASE("Bernoulli tags: exact sum -> agrees with sampled tags and with the limit for large numbers") {
  Rng rng{7, Stream::null_model};
  analysis::Mean sampled;
  for (int trial = 0; trial < 100'000; ++trial) {
    const auto mean_tag = [&](int coins) {
      int sum = 0;
      for (int i = 0; i < coins; ++i) sum += rng.chance(0.5) ? 1 : -1;
      return static_cast<double>(sum) / coins;
    };
    const double first = mean_tag(5);
    sampled.add(std::abs(first + mean_tag(13)));
  }
  CHECK(*sampled.value() == doctest::Approx(bernoulli_symmetry(5, 13)).epsilon(0.01));
  CHECK(bernoulli_symmetry(400, 600) ==
        doctest::Approx(std::sqrt(2.0 * (1.0 / 400 + 1.0 / 600) / std::numbers::pi)).epsilon(1e-3));
  CHECK(bernoulli_symmetry(401, 600) == doctest::Approx(bernoulli_symmetry(400, 600)).epsilon(2e-3));
  CHECK(bernoulli_symmetry(1, 999) == doctest::Approx(1.0));
  CHECK(bernoulli_symmetry(1000, 1) == doctest::Approx(1.0));  // for any sum of the thousand, it is as likely above as below -1
  for (const std::size_t few : {std::size_t{2}, std::size_t{7}, std::size_t{40}, std::size_t{248}}) {
    CHECK(bernoulli_symmetry(few, 1002 - few) == doctest::Approx(bernoulli_symmetry(few, 1000 - few)).epsilon(5e-4));
  }
  CHECK(bernoulli_symmetry(251, 751) == doctest::Approx(bernoulli_symmetry(249, 749)).epsilon(5e-3));
}

TEST_CASE("the paper's baseline: 100,000 pairs of uniform numbers give 2/3") {
  Rng rng{3, Stream::null_model};
  CHECK(analysis::uniform_pair_symmetry(rng) == doctest::Approx(2.0 / 3.0).epsilon(0.005));
}
