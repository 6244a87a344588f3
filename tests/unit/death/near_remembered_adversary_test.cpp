// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <support/hand_population.hpp>
#include <trophic/death/starvation/exemption/near_remembered_adversary.hpp>

using namespace trophic;
using namespace trophic::test;
using death::starvation::exemption::NearRememberedAdversary;

TEST_CASE("near remembered adversary: the stored distance decides, not where anybody stands now") {
  const NearRememberedAdversary rule;
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 0.1}}};
  const auto exempt = [&](const NearRememberedAdversary& any, double stored_m) {
    return any.is_exempt(0, robots.view(), robots.perceives(), {.adversary_distance_m = stored_m});
  };
  CHECK(exempt(rule, 4.9));
  CHECK_FALSE(exempt(rule, 5.0));
  robots.poses[1].x_m = 50.0;
  CHECK(exempt(rule, 4.9));
  CHECK(exempt({{.range_m = 6.0}}, 5.0));
}

TEST_CASE("near remembered adversary: a body that never perceived anybody is exempt") {
  const HandPopulation robots{{{.species = predator}}};
  const NearRememberedAdversary rule;
  CHECK(rule.is_exempt(0, robots.view(), robots.perceives(), rule.born({}, nullptr, {})));
}

TEST_CASE("near remembered adversary: the distance is stored while somebody is perceived and outlives blindness and births") {
  const NearRememberedAdversary rule;
  const HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 0.1}}};
  NearRememberedAdversary::State own;
  rule.on_sighting(own, 0, Sighting{.self = 0, .adversary = 1, .distance_m = 7.0}, robots.view());
  CHECK(own.adversary_distance_m == 7.0);
  rule.on_sighting(own, 0, std::nullopt, robots.view());
  CHECK(own.adversary_distance_m == 7.0);
  const NearRememberedAdversary::State parent{.adversary_distance_m = 3.0};
  CHECK(rule.born({}, &parent, own).adversary_distance_m == 7.0);
}
