// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <mujoco/touching.hpp>

using trophic::backend::Mujoco;

TEST_CASE("agreement: 30 robots that never touch, 20 s -> the same motion in islands and in one model") {
  const trophic::RobotModel spider = trophic::load_robot("spider");
  const trophic::Arena arena = trophic::load_arena("walled_square");
  std::vector<trophic::Pose> starts = trophic::test::lattice(spider, 30, 3.1);
  starts[29] = trophic::test::standing(spider, 9.85, -9.8, 0.4);  // walks against two walls
  Mujoco islands{spider, arena, starts, {}, {.stepping = Mujoco::Stepping::islands, .threads = 2}};
  Mujoco whole{spider, arena, starts, {}, {.stepping = Mujoco::Stepping::one_model}};
  trophic::test::TouchWatch watch{spider, arena, 30};
  for (double time_s = 1.0; time_s <= 20.0; time_s += 1.0) {
    trophic::test::walk(islands, time_s);
    trophic::test::walk(whole, time_s);
    watch.look(islands);
  }
  CHECK(watch.touched().empty());
  double farthest_m = 0.0;
  for (std::size_t i = 0; i < 30; ++i) {
    farthest_m = std::max(farthest_m, (islands.pose(i).position_m - starts[i].position_m).norm());
  }
  CHECK(farthest_m > 0.2);
  const double difference = trophic::test::largest_difference(islands, whole);
  MESSAGE("largest difference of any coordinate: ", difference);
  CHECK(difference < 1e-10);
}
