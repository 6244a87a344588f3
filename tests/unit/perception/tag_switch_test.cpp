// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <map>
#include <support/hand_population.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/perception/tag_switch/first_switch_free.hpp>
#include <trophic/perception/tag_switch/free_tags.hpp>
#include <trophic/perception/tag_switch/tag_sampling.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using namespace trophic::test;
using perception::MaySwitch;
using perception::tag_switch::FirstSwitchFree;

TEST_CASE("first switch free: no switch yet -> may switch at any time, also at birth") {
  test::HandPopulation robots{{{.tag = 1, .tag_since_s = 20.0}}};
  const FirstSwitchFree rule;
  FirstSwitchFree::State own = rule.born(robots.individuals[0], nullptr, {.newborn_tag = -1, .has_switched = true});
  for (const std::int64_t tick : {10, 11, 100}) {
    robots.at_tick(tick);
    rule.on_sighting(own, 0, std::nullopt, robots.view());
    CHECK(rule.may_switch(robots.individuals[0], robots.view(), own) == MaySwitch::yes);
  }
}

TEST_CASE("first switch free: seconds since the last switch -> may switch from exactly 50 s on, whatever the tag") {
  const FirstSwitchFree rule;
  test::HandPopulation robots{{{.tag = 1}}};
  FirstSwitchFree::State own = rule.born(robots.individuals[0], nullptr, {});
  robots.individuals[0].tag = -1;  // at the tick of its birth, so that the tag clock still stands at birth
  for (const int tag : {-1, 1}) {
    for (const auto& [tick, may] : std::map<std::int64_t, bool>{{1, false}, {24, false}, {25, true}}) {
      CAPTURE(tick);
      robots.at_tick(tick);
      rule.on_sighting(own, 0, std::nullopt, robots.view());
      robots.individuals[0].tag = tag;
      CHECK(rule.may_switch(robots.individuals[0], robots.view(), own) == (may ? MaySwitch::yes : MaySwitch::no));
    }
  }
}

TEST_CASE("first switch free: another cool-down -> from exactly then on") {
  test::HandPopulation robots{{{.tag_since_s = 10.0}}};
  const FirstSwitchFree rule{{.cool_down_s = 100.0}};
  const FirstSwitchFree::State own{.newborn_tag = -1, .has_switched = true};
  CHECK(rule.may_switch(robots.individuals[0], robots.at_tick(54).view(), own) == MaySwitch::no);
  CHECK(rule.may_switch(robots.individuals[0], robots.at_tick(55).view(), own) == MaySwitch::yes);
}

TEST_CASE("first switch free: in an ecology -> first switches also within 50 s of birth, later ones never") {
  struct {
    std::map<IndividualId, double> last_s = {};
    std::size_t at_birth = 0;
    std::size_t early = 0;
    void on_event(const observe::Event& event, const View& view) {
      if (event.kind != observe::EventKind::tag_switch) return;
      const auto [last, is_first] = last_s.try_emplace(event.individual.id, view.time_s);
      if (is_first) {
        if (view.time_s == event.individual.born_s) ++at_birth;
        if (view.time_s - event.individual.born_s < 50.0) ++early;
      } else {
        CHECK(view.time_s - last->second >= 50.0);
        last->second = view.time_s;
      }
    }
  } switches;
  Ecology<with_tag_switch<rules::Paper, FirstSwitchFree>>{{.seed = 3}, backend::Kinematic::Params{}}.run_until(1000.0, switches);
  CHECK(switches.at_birth > 0);
  CHECK(switches.early > switches.at_birth);
}

TEST_CASE("free tags: at the time of the last switch -> may switch") {
  HandPopulation robots{{{.species = prey, .tag_since_s = 200.0}}};
  robots.at_tick(100);
  CHECK(robots.view().time_s == 200.0);
  CHECK(perception::tag_switch::FreeTags{}.may_switch(robots.individuals[0], robots.view()) == perception::MaySwitch::yes);
}

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
