// SPDX-License-Identifier: MIT
// Eyes, by hand.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/sensors/rays.hpp>

using namespace trophic;
using namespace trophic::test;
using doctest::Approx;
using perception::sensors::Rays;
using perception::sensors::Sees;

namespace {

constexpr double radius_m = 0.25;

View seen(const HandPopulation& robots) {
  View view = robots.view();
  view.robot_radius_m = radius_m;
  return view;
}

template <class Sensor>
auto sensed(const Sensor& sensor, const View& view, BodyIndex self = 0) {
  Rng rng{1, Stream::user};
  return sensor.sense(self, std::nullopt, view, rng);
}

}  // namespace

TEST_CASE("rays: bodies and walls -> the first on each ray by its distance, what is behind it hidden") {
  // four rays: ahead on the left and right, behind on the right and left, at 45 degrees
  using Four = Rays<4, Sees::victims, Sees::hunters, Sees::kin, Sees::walls>;
  const Four rays{{.range_m = 4.0, .field_rad = 2.0 * std::numbers::pi}};
  HandPopulation robots{{{.species = predator, .x_m = 8.0, .y_m = 0.0, .heading_rad = 0.0},
                         {.species = prey, .x_m = 7.0, .y_m = -1.0},
                         {.species = predator, .x_m = 6.5, .y_m = -1.5},
                         {.species = predator, .x_m = 7.5, .y_m = 0.5},
                         {.species = prey, .x_m = 8.0, .y_m = 3.0}}};
  const double diagonal_m = std::sqrt(2.0);
  const auto close = [&](double at_m) { return Approx(1.0 - at_m / 4.0); };
  // rays from left to right: behind left, ahead left, ahead right, behind right
  const auto values = sensed(rays, seen(robots));
  const std::array<std::array<doctest::Approx, 4>, 4> expected{
      {{Approx(0.0), Approx(0.0), close(0.5 * diagonal_m - radius_m), Approx(0.0)},
       {Approx(0.0), Approx(0.0), Approx(0.0), close(2.0 * diagonal_m)},
       {Approx(0.0), Approx(0.0), Approx(0.0), close(2.0 * diagonal_m)},
       {close(diagonal_m - radius_m), Approx(0.0), Approx(0.0), Approx(0.0)}}};
  for (std::size_t ray = 0; ray < 4; ++ray) {
    for (std::size_t kind = 0; kind < 4; ++kind) {
      CAPTURE(ray);
      CAPTURE(kind);
      CHECK(values[4 * ray + kind] == expected[ray][kind]);
    }
  }
  // prey see the predator as a hunter, unless a spare body or a wall is there alone
  const auto of_prey = sensed(Rays<1, Sees::hunters>{{.range_m = 4.0, .field_rad = 0.1}}, seen(robots), 1);
  CHECK(of_prey[0] == 0.0);
  robots.poses[1].heading_rad = std::numbers::pi / 4.0;
  CHECK(sensed(Rays<1, Sees::hunters>{{.range_m = 4.0, .field_rad = 0.1}}, seen(robots), 1)[0] == close(diagonal_m - radius_m));
  robots.individuals[0] = spare_body(1, 0.0);
  CHECK(sensed(Rays<1, Sees::hunters>{{.range_m = 4.0, .field_rad = 0.1}}, seen(robots), 1)[0] == 0.0);
}

TEST_CASE("rays: wall between two robots -> each sees the wall, not the other, until it looks past its end") {
  HandPopulation robots{{{.species = predator, .x_m = -2.0}, {.species = prey, .x_m = 2.0, .heading_rad = std::numbers::pi}}};
  robots.arena.obstacles = {{.x_m = 0.0, .y_m = -1.0, .to_x_m = 0.0, .to_y_m = 1.0, .radius_m = 0.1}};
  const Rays<1, Sees::victims, Sees::hunters, Sees::walls> ahead{{.range_m = 5.0, .field_rad = 0.1}};
  for (const BodyIndex self : {BodyIndex{0}, BodyIndex{1}}) {
    const auto values = sensed(ahead, seen(robots), self);
    CHECK(values[0] == 0.0);
    CHECK(values[1] == 0.0);
    CHECK(values[2] == Approx(1.0 - 1.9 / 5.0));
  }
  robots.arena.obstacles[0].to_y_m = -0.2;
  CHECK(sensed(ahead, seen(robots), 0)[0] == Approx(1.0 - 3.75 / 5.0));
  CHECK(sensed(ahead, seen(robots), 1)[1] == Approx(1.0 - 3.75 / 5.0));
}

TEST_CASE("rays: any population -> as a walk along each ray in steps of a millimetre") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Rng rng{seed, Stream::user};
    std::vector<Robot> all;
    for (int i = 0; i < 60; ++i)
      all.push_back({.species = rng.chance(0.5) ? prey : predator,
                     .x_m = rng.uniform(-9.9, 9.9),
                     .y_m = rng.uniform(-9.9, 9.9),
                     .heading_rad = rng.uniform(-3.0, 3.0)});
    const HandPopulation robots{all};
    const View view = seen(robots);
    const auto values =
        sensed(Rays<9, Sees::victims, Sees::hunters, Sees::kin, Sees::walls>{{.range_m = 3.0, .field_rad = 4.0}}, view);
    for (std::size_t ray = 0; ray < 9; ++ray) {
      const double direction_rad = robots.poses[0].heading_rad + 2.0 - (static_cast<double>(ray) + 0.5) * 4.0 / 9.0;
      std::array<double, 4> walked{};
      for (double at_m = 0.0; at_m < 3.0; at_m += 0.001) {
        const GroundPose there{.x_m = robots.poses[0].x_m + at_m * std::cos(direction_rad),
                               .y_m = robots.poses[0].y_m + at_m * std::sin(direction_rad)};
        std::size_t kind = 4;
        for (BodyIndex other = 1; other < all.size(); ++other) {
          if (distance_m(there, robots.poses[other]) >= radius_m) continue;
          const bool is_kin = all[other].species == all[0].species;
          kind = is_kin ? 2 : all[0].species == predator ? 0 : 1;
        }
        if (std::max(std::abs(there.x_m), std::abs(there.y_m)) > robots.arena.half_side_m) kind = 3;
        if (kind == 4) continue;
        walked[kind] = 1.0 - at_m / 3.0;
        break;
      }
      for (std::size_t kind = 0; kind < 4; ++kind) CHECK(std::abs(values[4 * ray + kind] - walked[kind]) < 0.001);
    }
  }
}

TEST_CASE("rays: food -> the first cell with enough, unless a body hides it, around a torus too") {
  HandPopulation robots{{{.species = prey}, {.species = prey, .x_m = 5.0, .y_m = 5.0}}};
  ResourceField field{robots.arena, 20};
  field.food_J(field.cell_at(2.5, 0.5)) = 1.0;
  field.food_J(field.cell_at(-9.5, 9.5)) = 1.0;
  robots.poses[0].y_m = 0.5;
  View view = seen(robots);
  view.foods = {&field, 1};
  const Rays<1, Sees::food> ahead{{.range_m = 4.0, .field_rad = 0.1, .food_J = 0.5}};
  CHECK(sensed(ahead, view)[0] == Approx(0.5));
  CHECK(sensed(Rays<1, Sees::food>{{.range_m = 4.0, .field_rad = 0.1, .food_J = 2.0}}, view)[0] == 0.0);
  robots.poses[1] = {.x_m = 1.0, .y_m = 0.5};
  CHECK(sensed(ahead, view)[0] == 0.0);
  robots.poses[0] = {.x_m = 9.75, .y_m = 9.4};
  CHECK(sensed(ahead, view)[0] == 0.0);
  const View round{.web = robots.web,
                   .arena = robots.arena,
                   .robots = robots.individuals,
                   .poses = robots.poses,
                   .foods = {&field, 1},
                   .space = {.period_m = 20.0}};
  CHECK(sensed(ahead, round)[0] == Approx(1.0 - 0.25 / 4.0));
}
