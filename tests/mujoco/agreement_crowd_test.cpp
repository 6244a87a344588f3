// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <mujoco/touching.hpp>

using trophic::backend::Mujoco;

TEST_CASE("agreement: crowd of 30 robots that collide, 20 s -> the same motion in islands and in one model") {
  const trophic::RobotModel spider = trophic::load_robot("spider");
  const trophic::Arena arena = trophic::load_arena("walled_square");
  const std::vector<trophic::Pose> starts = trophic::test::tight_crowd(spider, 30, 4.0, 1000);
  Mujoco islands{spider, arena, starts, {}, {.stepping = Mujoco::Stepping::islands, .threads = 2}};
  Mujoco whole{spider, arena, starts, {}, {.stepping = Mujoco::Stepping::one_model}};
  trophic::test::TouchWatch watch{spider, arena, 30};
  for (double time_s = 0.1; time_s < 20.05; time_s += 0.1) {
    trophic::test::walk(islands, time_s);
    watch.look(islands);
  }
  trophic::test::walk(whole, islands.time_s());
  CHECK(watch.touched().size() >= 10);
  const double difference = trophic::test::largest_difference(islands, whole);
  MESSAGE(watch.touched().size(), " robots touched others; largest difference of any coordinate: ", difference);
  CHECK(difference < 1e-8);
}
