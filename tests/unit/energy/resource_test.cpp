// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/energy/resource/delayed_patches.hpp>
#include <trophic/energy/resource/logistic_field.hpp>
#include <trophic/energy/resource/moving_zones.hpp>
#include <trophic/energy/resource/no_resource.hpp>

using namespace trophic;
using namespace trophic::test;
using energy::resource::DelayedPatches;
using energy::resource::LogisticField;
using energy::resource::MovingZones;

namespace {

/// A field in an arena of 4 m x 4 m, and an empty world to grow it in.
template <class Policy>
struct Growing {
  explicit Growing(Policy policy) : rule{std::move(policy)} {
    world.arena.half_side_m = 2.0;
    field = rule.start(world.arena, rng);
  }
  void grow(int ticks) {
    for (int i = 0; i < ticks; ++i) rule.grow(field, world.at_tick(world.tick + 1).view(), rng);
  }
  Policy rule;
  HandPopulation world{{}};
  Rng rng{1, Stream::user};
  ResourceField field;
};

}  // namespace

TEST_CASE("logistic field: starts full, an eaten cell recovers along the logistic curve") {
  Growing<LogisticField> scene{
      LogisticField{{.cells_in_a_row = 4, .capacity_J_m2 = 10.0, .growth_1_s = 0.01, .seed_1_s = 0.0, .season = 0.0}}};
  CHECK(scene.field.total_J() == doctest::Approx(160.0));
  scene.grow(10);
  CHECK(scene.field.total_J() == doctest::Approx(160.0));
  scene.field.food_J(5) = 1.0;
  double expected_J = 1.0;
  for (int tick = 0; tick < 200; ++tick) expected_J += 2.0 * 0.01 * expected_J * (1.0 - expected_J / 10.0);
  scene.grow(200);
  CHECK(scene.field.food_J(5) == doctest::Approx(expected_J));
  CHECK(scene.field.food_J(5) == doctest::Approx(10.0 / (1.0 + 9.0 * std::exp(-4.0))).epsilon(0.02));
  CHECK(scene.field.food_J(6) == doctest::Approx(10.0));
}

TEST_CASE("logistic field: an empty cell recovers by its seed only") {
  Growing<LogisticField> none{LogisticField{{.cells_in_a_row = 2, .seed_1_s = 0.0}}};
  none.field.food_J(0) = 0.0;
  none.grow(1000);
  CHECK(none.field.food_J(0) == 0.0);
  Growing<LogisticField> seeded{LogisticField{{.cells_in_a_row = 2, .seed_1_s = 0.001, .season = 0.0}}};
  seeded.field.food_J(0) = 0.0;
  seeded.grow(1000);
  CHECK(seeded.field.food_J(0) == doctest::Approx(40.0));
}

TEST_CASE("logistic field: barren cells -> bear nothing, the others share their capacity") {
  Growing<LogisticField> scene{LogisticField{{.cells_in_a_row = 100, .capacity_J_m2 = 10.0, .barren = 0.75}}};
  std::size_t bare = 0U;
  for (std::size_t cell = 0; cell < scene.field.cells(); ++cell) bare += scene.field.food_J(cell) == 0.0 ? 1U : 0U;
  CHECK(bare == doctest::Approx(7500.0).epsilon(0.03));
  CHECK(scene.field.total_J() == doctest::Approx(160.0).epsilon(0.1));
  scene.grow(100);
  std::size_t still = 0;
  for (std::size_t cell = 0; cell < scene.field.cells(); ++cell) still += scene.field.food_J(cell) == 0.0 ? 1U : 0U;
  CHECK(still == bare);
}

TEST_CASE("logistic field: season -> growth stands still at its worst") {
  Growing<LogisticField> scene{
      LogisticField{{.cells_in_a_row = 1, .growth_1_s = 0.01, .seed_1_s = 0.0, .season = 1.0, .year_s = 1000.0}}};
  scene.field.food_J(0) = 1.0;
  scene.world.at_tick(374);  // 750 s, three quarters of a year
  scene.grow(1);
  CHECK(scene.field.food_J(0) == doctest::Approx(1.0));
  scene.world.at_tick(124);  // 250 s
  scene.grow(1);
  CHECK(scene.field.food_J(0) == doctest::Approx(1.0 + 2.0 * 0.02 * (1.0 - 1.0 / 160.0)));
}

TEST_CASE("delayed patches: a bite leaves a patch bare for the delay") {
  Growing<DelayedPatches> scene{DelayedPatches{{.patches_in_a_row = 4, .patch_J = 4.0, .delay_ticks = 3, .grown = 1.0}}};
  CHECK(scene.field.total_J() == doctest::Approx(64.0));
  scene.field.food_J(7) -= 1.0;
  scene.rule.on_bite(scene.field, 7, 1.0, 0, scene.world.view());
  CHECK(scene.field.food_J(7) == 0.0);
  scene.grow(3);
  CHECK(scene.field.food_J(7) == 0.0);
  scene.grow(1);
  CHECK(scene.field.food_J(7) == 4.0);
}

TEST_CASE("delayed patches: share that is grown at the start -> the others follow within the delay") {
  Growing<DelayedPatches> scene{DelayedPatches{{.patches_in_a_row = 60, .patch_J = 1.0, .delay_ticks = 30, .grown = 0.25}}};
  CHECK(scene.field.total_J() == doctest::Approx(900.0).epsilon(0.1));
  scene.grow(15);
  CHECK(scene.field.total_J() == doctest::Approx(900.0 + 1350.0).epsilon(0.1));
  scene.grow(16);
  CHECK(scene.field.total_J() == 3600.0);
}

TEST_CASE("moving zones: start -> as many as named, apart if there is room, together if not") {
  Arena arena;
  arena.half_side_m = 12.5;
  const auto nearest_m = [&](std::size_t number) {
    Rng rng{number, Stream::user};
    const ResourceField field = MovingZones{{.zones = number, .radius_m = 1.5, .apart_m = 4.0}}.start(arena, rng);
    const auto zones = zones_in(field);
    CHECK(zones.size() == number);
    double least_m = 100.0;
    for (const MatingZone& one : zones) {
      CHECK(one.radius_m == 1.5);
      for (const MatingZone& other : zones)
        if (other.cell != one.cell) least_m = std::min(least_m, distance_m(field.centre(one.cell), field.centre(other.cell)));
    }
    return least_m;
  };
  CHECK(nearest_m(15) >= 4.0);
  CHECK(nearest_m(200) < 4.0);
  Rng rng{1, Stream::user};
  CHECK_THROWS_AS(static_cast<void>((MovingZones{{.zones = 10, .cells_in_a_row = 3}}.start(arena, rng))), std::invalid_argument);
}

TEST_CASE("moving zones: a birth -> the zone that holds all parents moves, no other does") {
  HandPopulation robots{{{.x_m = -5.0}, {.x_m = -5.5}, {.x_m = 5.0}, {.x_m = 0.0, .y_m = 8.0}}};
  robots.arena.half_side_m = 12.5;
  const MovingZones rule{{.zones = 0, .radius_m = 2.0}};
  Rng rng{1, Stream::user};
  ResourceField field = rule.start(robots.arena, rng);
  const std::size_t left = field.cell_at(-5.0, 0.0);
  const std::size_t right = field.cell_at(5.0, 0.0);
  for (const std::size_t cell : {left, right}) field.set_zone(cell, 2.0);
  View view = robots.view();
  view.foods = {&field, 1};
  const auto after = [&](std::vector<BodyIndex> parents) {
    rule.on_birth(field, parents, view, rng);
    CHECK(zones_in(field).size() == 2);
    return std::pair{field.zone_m(left) > 0.0, field.zone_m(right) > 0.0};
  };
  CHECK(after({0, 2}) == std::pair{true, true});
  CHECK(after({3, 3}) == std::pair{true, true});
  CHECK(after({}) == std::pair{true, true});
  CHECK(after({0, 1}) == std::pair{false, true});
  CHECK(after({2}) == std::pair{false, false});
}

TEST_CASE("moving zones: food -> in equal parts where the living are, what is left is gone") {
  HandPopulation robots{{{.x_m = -5.0}, {.x_m = 5.0}, {.x_m = 5.0}, {.species = no_species, .y_m = 8.0}}};
  robots.arena.half_side_m = 12.5;
  const MovingZones rule{{.food_W = 6.0}};
  Rng rng{1, Stream::user};
  ResourceField field = rule.start(robots.arena, rng);
  for (int tick = 0; tick < 2; ++tick) {
    rule.grow(field, robots.view(), rng);
    CHECK(field.total_J() == doctest::Approx(12.0));
    CHECK(field.food_J(field.cell_at(robots.poses[0])) == doctest::Approx(4.0));
    CHECK(field.food_J(field.cell_at(robots.poses[1])) == doctest::Approx(8.0));
  }
}

TEST_CASE("no resource: no cells") {
  Growing<energy::resource::NoResource> scene{{}};
  scene.grow(1);
  CHECK(scene.field.cells() == 0);
}
