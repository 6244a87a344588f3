// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/exemption/near_perceived_victim.hpp>
#include <trophic/death/starvation/exemption/near_remembered_adversary.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>

using namespace trophic;
using namespace trophic::test;
using death::starvation::exemption::NearPerceivedVictim;
using death::starvation::exemption::NearRememberedAdversary;

namespace {

bool exempt(const NearPerceivedVictim& rule, const HandPopulation& robots) {
  return rule.is_exempt(0, robots.view(), robots.perceives());
}

}  // namespace

TEST_CASE("near perceived victim: perceived prey at exactly 5 m -> exempt, beyond -> not") {
  const NearPerceivedVictim rule;
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 5.0}}};
  CHECK(exempt(rule, robots));
  robots.poses[1].x_m = 5.0000001;
  CHECK_FALSE(exempt(rule, robots));
  CHECK(exempt(NearPerceivedVictim{{.range_m = 6.0}}, robots));
}

TEST_CASE("near perceived victim: prey switches its tag -> exemption ends") {
  const NearPerceivedVictim rule;
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 2.0}}};
  CHECK(exempt(rule, robots));
  robots.individuals[1].tag = -1;
  CHECK_FALSE(exempt(rule, robots));
}

TEST_CASE("near perceived victim: hidden prey nearby -> not exempt, visible one farther away -> exempt") {
  const NearPerceivedVictim rule;
  CHECK(exempt(rule, HandPopulation{{{.species = predator},
                                     {.species = prey, .x_m = 0.5, .tag = -1},
                                     {.species = prey, .x_m = 0.7, .active = false},
                                     {.species = prey, .x_m = 4.0}}}));
  CHECK_FALSE(exempt(rule, HandPopulation{{{.species = predator}, {.species = predator, .x_m = 1.0}}}));
  CHECK_FALSE(exempt(rule, HandPopulation{{{.species = predator}}}));
}

TEST_CASE("near perceived victim: own predator nearby -> not exempt") {
  const HandPopulation robots{{{.species = grazer}, {.species = hunter, .x_m = 1.0}, {.species = plant, .x_m = 4.0}},
                              chain_web()};
  CHECK(exempt(NearPerceivedVictim{}, robots));
  CHECK_FALSE(exempt(NearPerceivedVictim{{.range_m = 2.0}}, robots));
}

TEST_CASE("near remembered adversary: current positions differ from the stored distance -> the stored one decides") {
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

TEST_CASE("near remembered adversary: body without any perception -> exempt") {
  const HandPopulation robots{{{.species = predator}}};
  const NearRememberedAdversary rule;
  CHECK(rule.is_exempt(0, robots.view(), robots.perceives(), rule.born({}, nullptr, {})));
}

TEST_CASE("near remembered adversary: no target perceived, or a birth -> stored distance kept") {
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

TEST_CASE("no exemption: predator next to a prey -> not exempt") {
  const HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 0.5}}};
  CHECK_FALSE(death::starvation::exemption::NoExemption{}.is_exempt(0, robots.view(), robots.perceives()));
}
