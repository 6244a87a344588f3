// SPDX-License-Identifier: MIT
// Obstacles and rough ground on every backend: TEST_CASE_TEMPLATE_INVOKE(trophic_ground_suite, MyBackend);
#pragma once

#include <conformance/backend_suite.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::conformance {

/// Robots that walk at a pillar and at a wall stop there; without them they would pass. A world without walls refuses obstacles.
template <Backend B>
void check_obstacles() {
  World<B> world{2};
  if constexpr (requires { B::is_periodic; }) {
    world.arena.obstacles = {Obstacle{}};
    CHECK_THROWS_AS(static_cast<void>(world.make()), std::invalid_argument);
    return;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const double y_m = 4.0 * static_cast<double>(i);
    world.starts[i].position_m = {0.0, y_m, world.robot.rest_height_m};
    world.starts[i].orientation = Eigen::AngleAxisd{-world.robot.forward_rad, Eigen::Vector3d::UnitZ()};
  }
  const std::vector<Obstacle> obstacles{
      {.x_m = 0.65, .y_m = 0.0, .to_x_m = 0.65, .to_y_m = 0.0, .radius_m = 0.4, .height_m = 0.4},
      {.x_m = 0.4, .y_m = 3.0, .to_x_m = 0.4, .to_y_m = 5.0, .radius_m = 0.05, .height_m = 0.4}};
  const auto closest_m = [&](bool has_obstacles) {
    world.arena.obstacles = has_obstacles ? obstacles : std::vector<Obstacle>{};
    B backend = world.make();
    Driver driver{2, walkers[0], 0.0};
    std::array<double, 2> closest{1.0, 1.0};
    for (double time_s = 0.5; time_s <= 20.0; time_s += 0.5) {
      driver.drive(backend, time_s);
      for (std::size_t i = 0; i < 2; ++i) {
        const Eigen::Vector3d at = backend.pose(i).position_m;
        closest[i] = std::min(closest[i], distance_m(obstacles[i], at.x(), at.y()));
      }
    }
    return closest;
  };
  const auto stopped = closest_m(true);
  const auto passed = closest_m(false);
  for (std::size_t i = 0; i < 2; ++i) {
    CAPTURE(i);
    CHECK(stopped[i] > 0.02);
    CHECK(stopped[i] < 0.3);
    CHECK(passed[i] < stopped[i] - 0.03);
  }
  world.arena.obstacles = obstacles;
  world.starts[1].position_m = {0.65, 0.1, world.robot.rest_height_m};
  CHECK_THROWS_AS(static_cast<void>(world.make()), std::invalid_argument);
}

/// Robots start and walk on a floor with bumps of up to a centimetre.
template <Backend B>
void check_rough_ground() {
  World<B> world{3};
  HeightField field{.nodes = 41, .half_extent_m = 10.0, .height_m = {}};
  Rng rng{1, Stream::user};
  for (std::size_t i = 0; i < field.nodes * field.nodes; ++i) {
    const std::size_t ring = std::min({i % 41, i / 41, 40 - i % 41, 40 - i / 41});
    field.height_m.push_back(ring == 0 ? 3.0 : rng.uniform(0.0, 0.01));
  }
  world.arena.height_field = field;
  world.arena.half_side_m = 9.5;
  for (Pose& start : world.starts) start.position_m.z() += 0.01;
  B backend = world.make();
  Driver driver{3};
  driver.drive(backend, 6.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d way_m = backend.pose(i).position_m - world.starts[i].position_m;
    CHECK(std::hypot(way_m.x(), way_m.y()) > 0.05);
    CHECK(std::abs(way_m.z()) < 0.05);
  }
}

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("ground", B, trophic_ground_suite) {
  using namespace trophic;
  SUBCASE("obstacles stop robots") {
    conformance::check_obstacles<B>();
  }
  SUBCASE("robots walk on rough ground") {
    conformance::check_rough_ground<B>();
  }
}
