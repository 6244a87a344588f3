// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/tag_switch/tag_cool_down.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("tag cool-down: exactly 50 s or more after the last switch or birth -> may switch") {
  const perception::tag_switch::TagCoolDown rule;
  HandPopulation robots{{{.tag_since_s = 0.0}, {.tag_since_s = 30.0}}};
  const auto may = [&](BodyIndex body, std::int64_t tick) {
    robots.at_tick(tick);
    return rule.may_switch(robots.individuals[body], robots.view()) != perception::MaySwitch::no;
  };
  CHECK_FALSE(may(0, 0));
  CHECK_FALSE(may(0, 24));
  CHECK(may(0, 25));
  CHECK(may(0, 1000));
  CHECK_FALSE(may(1, 39));
  CHECK(may(1, 40));
}

TEST_CASE("tag cool-down: decisions without a switch -> clock unchanged") {
  const HandPopulation robots = HandPopulation{{{.species = prey}}}.at_tick(1000);
  CHECK(perception::tag_switch::TagCoolDown{}.may_switch(robots.individuals[0], robots.view()) == perception::MaySwitch::yes);
}

TEST_CASE("tag cool-down: another cool-down, or 0 -> as set") {
  HandPopulation robots{{{.tag_since_s = 10.0}}};
  const auto may = [&](double cool_down_s, std::int64_t tick) {
    robots.at_tick(tick);
    return perception::tag_switch::TagCoolDown{{.cool_down_s = cool_down_s}}.may_switch(robots.individuals[0], robots.view()) ==
           perception::MaySwitch::yes;
  };
  CHECK_FALSE(may(100.0, 54));
  CHECK(may(100.0, 55));
  CHECK(may(0.0, 5));
}
