// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <support/hand_population.hpp>
#include <trophic/perception/sensors/tag_ratio_of_active.hpp>

using namespace trophic;
using namespace trophic::test;

namespace {

double ratio_of(const perception::sensors::TagRatioOfActive& rule, const View& view) {
  return rule.sense(view)[0];
}

}  // namespace

TEST_CASE("tag ratio of active: inactive newborn -> not counted") {
  const perception::sensors::TagRatioOfActive rule;
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = 1}, {.tag = 1}, {.tag = -1}}}.view()) == 0.25);
  CHECK(ratio_of(rule,
                 HandPopulation{{{.tag = 1}, {.tag = 1, .active = false}, {.tag = -1}, {.tag = -1, .active = false}}}.view()) ==
        0.0);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1}, {.tag = -1, .active = false}}}.view()) == 0.5);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = -1}, {.tag = 1, .active = false}}}.view()) == -0.5);
  CHECK(ratio_of(rule, HandPopulation{{{.tag = 1, .active = false}}}.view()) == 0.0);
}

TEST_CASE("tag ratio of active: random populations -> within +-1/2, odd in all tags, any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    const perception::sensors::TagRatioOfActive rule;
    HandPopulation robots = random_population(seed, 1 + seed % 30);
    const double ratio = ratio_of(rule, robots.view());
    RC_ASSERT(std::abs(ratio) <= 0.5);
    RC_ASSERT(ratio_of(rule, robots.reordered(random_order(seed, robots.individuals.size())).view()) == ratio);
    for (Individual& individual : robots.individuals) individual.tag = -individual.tag;
    RC_ASSERT(ratio_of(rule, robots.view()) == -ratio);
  }));
}
