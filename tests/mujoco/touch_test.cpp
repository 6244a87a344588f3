// SPDX-License-Identifier: MIT
// Touching robots by the shapes of boxes are those by the engine.
#include <doctest/doctest.h>

#include <mujoco/touching.hpp>
#include <mujoco/worlds.hpp>
#include <set>
#include <trophic/habitat/touch.hpp>
#include <utility>
#include <vector>

using namespace trophic;

TEST_CASE("touch: crowd at a wall -> the engine's contacts") {
  const std::size_t robots = 12;
  std::vector<Pose> starts = test::crowd(test::spider, robots, 1.6, 5);
  for (Pose& start : starts) {
    start.position_m.x() = test::square.half_side_m - 0.25 + 0.1 * start.position_m.x();
    start.position_m.y() *= 1.5;
  }
  backend::Mujoco world{test::spider, test::square, starts, Physics{}, {}};
  test::TouchWatch engine{test::spider, test::square, robots};
  std::size_t touches = 0;
  std::size_t at_wall = 0;
  for (int step = 0; step < 240; ++step) {
    for (std::size_t i = 0; i < robots; ++i) {
      world.set_joint_targets(i, test::own_gait(i, test::spider.hinges.size(), world.time_s()));
    }
    world.advance_to((step + 1) * test::control_period_s);
    engine.look(world);
    std::vector<std::vector<PlacedBox>> bodies;
    for (std::size_t i = 0; i < robots; ++i) bodies.push_back(placed_boxes(test::spider, world.pose(i), world.joint_angles(i)));
    std::set<std::pair<int, int>> pairs;
    std::set<int> walls;
    for (int i = 0; i < static_cast<int>(robots); ++i) {
      if (touch_wall(bodies[static_cast<std::size_t>(i)], test::square.half_side_m)) walls.insert(i);
      for (int j = i + 1; j < static_cast<int>(robots); ++j) {
        if (touch(bodies[static_cast<std::size_t>(i)], bodies[static_cast<std::size_t>(j)])) pairs.insert({i, j});
      }
    }
    CAPTURE(step);
    CHECK(pairs == engine.pairs());
    CHECK(walls == engine.at_wall());
    touches += pairs.size();
    at_wall += walls.size();
  }
  CHECK(touches > 100);
  CHECK(at_wall > 10);
}
