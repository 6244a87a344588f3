// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/tag_switch/tag_sampling.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("tag sampling: 100 s after the clock's start -> brain's tag sampled, clock restarts in any case") {
  const perception::tag_switch::TagSampling rule;
  HandPopulation robots{{{.tag_since_s = 0.0}, {.tag_since_s = 30.0}}};
  const auto may = [&](BodyIndex body, std::int64_t tick) {
    robots.at_tick(tick);
    return rule.may_switch(robots.individuals[body], robots.view()) != perception::MaySwitch::no;
  };
  CHECK_FALSE(may(0, 49));
  CHECK(may(0, 50));
  CHECK_FALSE(may(1, 64));
  CHECK(may(1, 65));
  CHECK(rule.may_switch(robots.individuals[0], robots.at_tick(50).view()) == perception::MaySwitch::yes_and_clock_restarts);
}

TEST_CASE("tag sampling: another period -> as set") {
  HandPopulation robots{{{.tag_since_s = 0.0}}};
  robots.at_tick(3);
  CHECK(perception::tag_switch::TagSampling{{.period_s = 6.0}}.may_switch(robots.individuals[0], robots.view()) !=
        perception::MaySwitch::no);
  CHECK(perception::tag_switch::TagSampling{{.period_s = 7.0}}.may_switch(robots.individuals[0], robots.view()) ==
        perception::MaySwitch::no);
}
