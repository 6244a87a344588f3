// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <support/hand_population.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/activation/ages_once_away_from_hunters.hpp>
#include <trophic/death/activation/always_active.hpp>
#include <trophic/death/activation/founders_start_active.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using namespace trophic::test;
using death::Activates;
using death::activation::ActiveAwayFromHunters;
using death::activation::AgesOnceAwayFromHunters;
using death::activation::FoundersStartActive;

TEST_CASE("active away from hunters: farther than 5 m from every predator -> active, at exactly 5 m -> not") {
  const ActiveAwayFromHunters rule;
  HandPopulation robots{
      {{.species = prey, .active = false}, {.species = predator, .x_m = 5.0}, {.species = predator, .x_m = -9.0}}};
  CHECK(rule.activates(0, robots.view()) == Activates::no);
  robots.poses[1].x_m = 5.0000001;
  CHECK(rule.activates(0, robots.view()) == Activates::yes);
  robots.poses[2].x_m = -3.0;
  CHECK(rule.activates(0, robots.view()) == Activates::no);
  CHECK(ActiveAwayFromHunters{{.distance_m = 2.0}}.activates(0, robots.view()) == Activates::yes);
}

TEST_CASE("active away from hunters: predator with the other tag -> counts, prey nearby -> ignored") {
  const ActiveAwayFromHunters rule;
  CHECK(
      rule.activates(
          0,
          HandPopulation{{{.species = prey, .tag = 1, .active = false}, {.species = predator, .x_m = 1.0, .tag = -1}}}.view()) ==
      Activates::no);
  CHECK(rule.activates(0, HandPopulation{{{.species = prey, .active = false}, {.species = prey, .x_m = 0.1}}}.view()) ==
        Activates::yes);
}

TEST_CASE("active away from hunters: food chain -> only species that eat the newborn count") {
  const ActiveAwayFromHunters rule;
  const HandPopulation robots{{{.species = plant, .active = false},
                               {.species = hunter, .x_m = 1.0},
                               {.species = grazer, .x_m = 6.0, .active = false},
                               {.species = grazer, .x_m = 6.5, .active = false}},
                              chain_web()};
  CHECK(rule.activates(0, robots.view()) == Activates::yes);
  CHECK(rule.activates(2, robots.view()) == Activates::no);  // 5 m from the hunter
  CHECK(rule.activates(3, robots.view()) == Activates::yes);
}

TEST_CASE("active away from hunters: any order of bodies -> same result") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 10, chain_web());
    const auto order = random_order(seed, 10);
    const HandPopulation moved = robots.reordered(order);
    for (BodyIndex body = 0; body < 10; ++body) {
      RC_ASSERT(ActiveAwayFromHunters{}.activates(body, moved.view()) ==
                ActiveAwayFromHunters{}.activates(order[body], robots.view()));
    }
  }));
}

TEST_CASE("ages once away from hunters: farther than 5 m from every predator -> active, age restarts") {
  const AgesOnceAwayFromHunters rule;
  HandPopulation robots{
      {{.species = prey, .active = false}, {.species = predator, .x_m = 5.0, .tag = -1}, {.species = prey, .x_m = 0.1}}};
  CHECK(rule.activates(0, robots.view()) == Activates::no);
  robots.poses[1].x_m = 5.0000001;
  CHECK(rule.activates(0, robots.view()) == Activates::yes_and_restarts_age);
  CHECK(AgesOnceAwayFromHunters{{.distance_m = 6.0}}.activates(0, robots.view()) == Activates::no);
}

TEST_CASE("always active: predator at the same place -> active, age counts from birth") {
  const HandPopulation robots{{{.species = prey, .active = false}, {.species = predator}}};
  CHECK(death::activation::AlwaysActive{}.activates(0, robots.view()) == death::Activates::yes);
}

TEST_CASE("founders start active: id and distance to a predator -> whether it becomes active") {
  struct Case {
    IndividualId id;
    double distance_m;
    bool activates;
  };
  for (const auto& [id, distance_m, activates] : {Case{0, 0.1, true}, Case{1, 0.1, true}, Case{2, 0.1, false},
                                                  Case{2, 5.0, false}, Case{2, 5.1, true}, Case{40, 4.0, false}}) {
    CAPTURE(id);
    CAPTURE(distance_m);
    const HandPopulation robots{
        {{.species = prey, .active = false, .id = id}, {.species = predator, .x_m = distance_m, .id = 50}}};
    CHECK(FoundersStartActive{}.activates(0, robots.view()) == (activates ? Activates::yes : Activates::no));
  }
}

TEST_CASE("founders start active: another distance -> affects only later newborn") {
  const HandPopulation robots{{{.species = prey, .active = false, .id = 0},
                               {.species = prey, .active = false, .id = 7},
                               {.species = predator, .x_m = 3.0, .id = 1}}};
  CHECK(FoundersStartActive{{.distance_m = 2.0}}.activates(1, robots.view()) == Activates::yes);
  CHECK(FoundersStartActive{{.distance_m = 4.0}}.activates(1, robots.view()) == Activates::no);
  CHECK(FoundersStartActive{{.distance_m = 4.0}}.activates(0, robots.view()) == Activates::yes);
}

TEST_CASE("founders start active: after the first tick of an ecology -> all founders are active, as not in the paper's table") {
  struct {
    std::size_t inactive = 0;
    void on_tick(const View& view) {
      for (const Individual& one : view.robots) {
        if (one.id < view.robots.size() && !one.active) ++inactive;
      }
    }
  } founders, founders_of_paper;
  Ecology<with_activation<rules::Paper, FoundersStartActive>>{{.seed = 1}, backend::Kinematic::Params{}}.run_until(4.0, founders);
  Ecology<rules::Paper>{{.seed = 1}, backend::Kinematic::Params{}}.run_until(4.0, founders_of_paper);
  CHECK(founders.inactive == 0);
  CHECK(founders_of_paper.inactive > 0);
}
