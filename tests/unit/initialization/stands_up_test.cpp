// SPDX-License-Identifier: MIT
// How a newborn's body takes the place of the old one.
#include <doctest/doctest.h>

#include <stdexcept>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/habitat/touch.hpp>
#include <trophic/initialization/embodiment/keeps_body.hpp>
#include <trophic/initialization/embodiment/stands_up.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using initialization::embodiment::StandsUp;

namespace {

const RobotModel& spider() {
  static const RobotModel robot = load_robot("spider");
  return robot;
}

double heading_rad(const Pose& pose) {
  const Eigen::Vector3d ahead = pose.orientation * Eigen::Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

/// Robots at rest in an arena, each set down among the others.
struct Crowd {
  std::vector<const RobotModel*> models = {};
  std::vector<Pose> poses = {};

  [[nodiscard]] std::vector<PlacedBox> boxes(std::size_t robot) const { return placed_boxes(*models[robot], poses[robot], {}); }
  [[nodiscard]] std::vector<PlacedBox> others(std::size_t robot) const {
    std::vector<PlacedBox> all;
    for (std::size_t other = 0; other < models.size(); ++other) {
      if (other == robot || models[other] == nullptr) continue;
      const auto own = boxes(other);
      all.insert(all.end(), own.begin(), own.end());
    }
    return all;
  }
};

}  // namespace

TEST_CASE("stands up: free place -> there, upright, with the old heading and feet on the floor") {
  const GroundPose place{.x_m = 1.5, .y_m = -2.0, .heading_rad = 0.75};
  const Pose pose = StandsUp{}.set_down(place, spider(), load_arena("walled_square"), {});
  CHECK(pose.position_m == Eigen::Vector3d{1.5, -2.0, spider().rest_height_m});
  CHECK(heading_rad(pose) + spider().forward_rad == doctest::Approx(0.75));
  CHECK((pose.orientation * Eigen::Vector3d::UnitZ()).z() == doctest::Approx(1.0));
}

TEST_CASE("stands up: at a wall -> moved inwards until it does not touch it, and no farther") {
  const Arena arena = load_arena("walled_square");
  const GroundPose corner{.x_m = arena.half_side_m - 0.05, .y_m = 0.05 - arena.half_side_m};
  const Pose pose = StandsUp{}.set_down(corner, spider(), arena, {});
  CHECK_FALSE(touch_wall(placed_boxes(spider(), pose, {}), arena.half_side_m));
  CHECK(touch_wall(placed_boxes(spider(), pose, {}), arena.half_side_m - 0.012));
}

TEST_CASE("stands up: place taken -> the nearest ring that is free, no ring free -> above, in an arena of one body's size") {
  const Arena arena = load_arena("walled_square");
  const Pose taken = StandsUp{}.set_down({}, spider(), arena, {});
  const auto others = placed_boxes(spider(), taken, {});
  const Pose beside = StandsUp{}.set_down({}, spider(), arena, others);
  const double away_m = beside.position_m.head<2>().norm();
  CHECK(away_m > 0.05);
  CHECK(away_m < 2.0 * spider().bounding_radius_m);
  CHECK(std::remainder(away_m, 0.05) == doctest::Approx(0.0));
  CHECK_FALSE(touch(placed_boxes(spider(), beside, {}), others));
  Arena tight = arena;
  tight.half_side_m = 0.3;
  const Pose above = StandsUp{}.set_down({}, spider(), tight, others);
  CHECK(above.position_m.z() > spider().rest_height_m + 0.02);
  CHECK_FALSE(touch(placed_boxes(spider(), above, {}), others));
}

TEST_CASE(
    "stands up: 1000 births of two bodies in a crowd -> none touches another or a wall, and equal crowds give equal poses") {
  const RobotModel gecko = load_robot("gecko");
  Arena arena = load_arena("walled_square");
  arena.half_side_m = 1.6;
  Crowd crowd{.models = std::vector<const RobotModel*>(20), .poses = std::vector<Pose>(20)};
  Rng rng{1, Stream::user};
  std::size_t moved = 0;
  for (std::size_t birth = 0; birth < 1000; ++birth) {
    const std::size_t robot = birth % crowd.models.size();
    crowd.models[robot] = rng.chance(0.5) ? &gecko : &spider();
    const GroundPose place{.x_m = rng.uniform(-1.6, 1.6), .y_m = rng.uniform(-1.6, 1.6), .heading_rad = rng.uniform(-3.0, 3.0)};
    const auto others = crowd.others(robot);
    crowd.poses[robot] = StandsUp{}.set_down(place, *crowd.models[robot], arena, others);
    const auto own = crowd.boxes(robot);
    REQUIRE_FALSE(touch(own, others));
    REQUIRE_FALSE(touch_wall(own, arena.half_side_m));
    moved +=
        distance_m(place, {.x_m = crowd.poses[robot].position_m.x(), .y_m = crowd.poses[robot].position_m.y()}) > 0.01 ? 1U : 0U;
    if (birth % 100 != 0) continue;
    CHECK(StandsUp{}.set_down(place, *crowd.models[robot], arena, others).position_m == crowd.poses[robot].position_m);
  }
  CHECK(moved > 300);
}

TEST_CASE("keeps body: set down -> refused, as it sets no body down") {
  CHECK_THROWS_AS(static_cast<void>(initialization::embodiment::KeepsBody{}.set_down({}, spider(), {}, {})), std::logic_error);
}
