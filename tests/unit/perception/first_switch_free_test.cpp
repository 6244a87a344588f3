// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <map>
#include <support/hand_population.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/perception/tag_switch/first_switch_free.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
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
