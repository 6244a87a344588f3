// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/recruitment/in_zones.hpp>

using namespace trophic;
using namespace trophic::test;
using reproduction::recruitment::InZones;

namespace {

/// A world of 25 m with zones of 2 m at x = -5 and x = 5.
struct TwoZones {
  explicit TwoZones(const std::vector<Robot>& list) : robots{list} {
    robots.arena.half_side_m = 12.5;
    field = ResourceField{robots.arena, 25};
    for (const double x_m : {-5.0, 5.0}) field.set_zone(field.cell_at(x_m, 0.0), 2.0);
    for (Individual& one : robots.individuals) one.energy_J = 80.0;
    robots.at_tick(29);
  }
  [[nodiscard]] std::vector<reproduction::Recruit> births(InZones::Params params = {.interval_ticks = 30, .offspring = 1}) const {
    View view = robots.view();
    view.foods = {&field, 1};
    Rng rng{1, Stream::user};
    return InZones{params}.recruits(view, rng);
  }
  [[nodiscard]] std::vector<std::vector<IndividualId>> pairs() const {
    std::vector<std::vector<IndividualId>> all;
    for (const auto& birth : births()) {
      all.emplace_back();
      for (const Ancestor& parent : birth.parents) all.back().push_back(parent.id);
    }
    return all;
  }
  HandPopulation robots;
  ResourceField field;
};

using ParentIds = std::vector<std::vector<IndividualId>>;

}  // namespace

TEST_CASE("in zones: zones that are empty or hold one -> no birth") {
  CHECK(TwoZones{{}}.pairs().empty());
  CHECK(TwoZones{{{.x_m = -5.0}, {.x_m = 5.0}, {.x_m = 0.0}, {.x_m = 0.1}}}.pairs().empty());
}

TEST_CASE("in zones: a pair -> a birth, only at the last tick of an interval, and only with zones") {
  TwoZones scene{{{.x_m = -5.0}, {.x_m = -5.5}}};
  CHECK(scene.pairs() == ParentIds{{0, 1}});
  for (const std::int64_t tick : {28, 30, 58}) {
    scene.robots.at_tick(tick);
    CHECK(scene.pairs().empty());
  }
  scene.robots.at_tick(59);
  CHECK(scene.pairs() == ParentIds{{0, 1}});
  scene.field = ResourceField{scene.robots.arena, 25};
  CHECK(scene.pairs().empty());
}

TEST_CASE("in zones: three in one zone -> the oldest takes the nearest, the third has no mate, four make two pairs") {
  TwoZones scene{{{.x_m = -5.0, .id = 7}, {.x_m = -5.5, .id = 3}, {.x_m = -4.0, .id = 5}}};
  CHECK(scene.pairs() == ParentIds{{3, 7}});
  scene.robots.individuals[1].id = 9;
  CHECK(scene.pairs() == ParentIds{{5, 7}});
  CHECK(TwoZones{{{.x_m = -5.0}, {.x_m = -4.0}, {.x_m = -5.2}, {.x_m = -4.2}}}.pairs() == ParentIds{{0, 2}, {1, 3}});
  CHECK(TwoZones{{{.x_m = -5.0}, {.x_m = 5.0}, {.x_m = -5.2}, {.x_m = 4.2}}}.pairs() == ParentIds{{0, 2}, {1, 3}});
}

TEST_CASE("in zones: another species, and bodies without an individual -> no mates") {
  CHECK(TwoZones{{{.species = prey, .x_m = -5.0}, {.species = predator, .x_m = -5.1}}}.pairs().empty());
  CHECK(TwoZones{{{.species = prey, .x_m = -5.0}, {.species = no_species, .x_m = -5.1}, {.x_m = -4.0}}}.pairs() ==
        ParentIds{{0, 2}});
}

TEST_CASE("in zones: energy below the cost -> both give what the poorer one has, without any no mate") {
  TwoZones scene{{{.x_m = -5.0}, {.x_m = -5.5}}};
  CHECK(scene.births().at(0).endowment_J == 50.0);
  scene.robots.individuals[1].energy_J = 10.0;
  CHECK(scene.births().at(0).endowment_J == 20.0);
  scene.robots.individuals[1].energy_J = 0.0;
  CHECK(scene.births().empty());
}

TEST_CASE("in zones: two newborns -> each near one parent at the step, half of the energy each, without a step no place") {
  const TwoZones scene{{{.x_m = -5.0}, {.x_m = -5.5}}};
  const auto births = scene.births({.interval_ticks = 30, .offspring = 2, .cost_J = 25.0, .step_m = 3.0});
  REQUIRE(births.size() == 2);
  for (const BodyIndex parent : {BodyIndex{0}, BodyIndex{1}}) {
    CHECK(births[parent].parents.front().id == parent);
    CHECK(births[parent].parents.size() == 2);
    CHECK(births[parent].endowment_J == 25.0);
    CHECK(distance_m(births[parent].place.value(), scene.robots.poses[parent]) == doctest::Approx(3.0));
  }
  CHECK_FALSE(scene.births({.interval_ticks = 30, .step_m = 0.0}).at(0).place);
  CHECK(InZones{{.spare_bodies = 7}}.spare_bodies() == 7);
  CHECK(InZones{}.leaves_spare({.body = 0, .cause = Cause::starved}, scene.robots.view()));
}
