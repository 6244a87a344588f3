// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/energy/resource/delayed_patches.hpp>
#include <trophic/energy/resource/logistic_field.hpp>
#include <trophic/energy/resource/no_resource.hpp>

using namespace trophic;
using namespace trophic::test;
using energy::resource::DelayedPatches;
using energy::resource::LogisticField;

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

TEST_CASE("no resource: no cells") {
  Growing<energy::resource::NoResource> scene{{}};
  scene.grow(1);
  CHECK(scene.field.cells() == 0);
}
