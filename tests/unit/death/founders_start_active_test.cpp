// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/activation/founders_start_active.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using namespace trophic::test;
using death::Activates;
using death::activation::FoundersStartActive;

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
