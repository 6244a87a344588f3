// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/recruitment/no_recruitment.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no recruitment: any death -> filled at once, no births without a death") {
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 0.5}}};
  const reproduction::recruitment::NoRecruitment rule;
  Rng rng{1, Stream::recruitment};
  CHECK(rule.spare_bodies() == 0);
  for (const Cause cause : {Cause::caught, Cause::starved, Cause::sacrificed, Cause::senescence}) {
    CHECK_FALSE(rule.leaves_spare({.body = 0, .cause = cause}, robots.view()));
  }
  CHECK(rule.recruits(robots.view(), rng).empty());
}
