// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/habitat/link_frames.hpp>
#include <trophic/habitat/touch.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;

namespace {

PlacedBox placed(const Eigen::Vector3d& half_m, const Eigen::Vector3d& centre_m, const Eigen::Quaterniond& turn) {
  return {.centre_m = centre_m, .half_edges_m = turn.toRotationMatrix() * half_m.asDiagonal(), .radius_m = half_m.norm()};
}

Eigen::Quaterniond drawn_turn(Rng& rng) {
  return Eigen::Quaterniond{rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0)}.normalized();
}
Eigen::Vector3d drawn_point(Rng& rng, double side_m) {
  return {rng.uniform(-side_m, side_m), rng.uniform(-side_m, side_m), rng.uniform(-side_m, side_m)};
}

/// The distance between two boxes, 0 where they overlap: projections on both in turn come as close as they can.
double distance_m(const PlacedBox& a, const PlacedBox& b) {
  const auto closest = [](const PlacedBox& box, const Eigen::Vector3d& point) {
    Eigen::Vector3d at = box.centre_m;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d edge = box.half_edges_m.col(i);
      at += std::clamp(edge.dot(point - box.centre_m) / edge.squaredNorm(), -1.0, 1.0) * edge;
    }
    return at;
  };
  Eigen::Vector3d in_a = a.centre_m;
  Eigen::Vector3d in_b = b.centre_m;
  for (int i = 0; i < 20000; ++i) {
    in_b = closest(b, in_a);
    in_a = closest(a, in_b);
  }
  return (in_a - in_b).norm();
}

/// A root of 2 m x 1 m x 1 m with an arm of 2 m that turns about the root's y axis, 1 m before its middle.
RobotModel arm() {
  RobotModel robot;
  robot.links.resize(2);
  robot.links[0].boxes.resize(1);
  robot.links[0].boxes[0].half_extents_m = {1.0, 0.5, 0.5};
  robot.links[1].parent = 0;
  robot.links[1].offset_m = {1.0, 0.0, 0.0};
  robot.links[1].boxes.resize(1);
  robot.links[1].boxes[0].half_extents_m = {1.0, 0.1, 0.1};
  robot.links[1].boxes[0].centre_m = {1.0, 0.0, 0.0};
  robot.hinges.resize(1);
  robot.hinges[0].axis = Eigen::Vector3d::UnitY();
  return robot;
}

}  // namespace

TEST_CASE("link frames: bent arm of a turned body -> direction of its joint angle") {
  const RobotModel robot = arm();
  const Pose root{{0.0, 0.0, 3.0}, Eigen::Quaterniond{Eigen::AngleAxisd{std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ()}}};
  const std::vector<double> bent{-std::numbers::pi / 2.0};
  const Eigen::Vector3d straight_tip_m = link_frames(robot, root, {})[1] * Eigen::Vector3d{2.0, 0.0, 0.0};
  const Eigen::Vector3d bent_tip_m = link_frames(robot, root, bent)[1] * Eigen::Vector3d{2.0, 0.0, 0.0};
  CHECK((straight_tip_m - Eigen::Vector3d{0.0, 3.0, 3.0}).norm() < 1e-12);
  CHECK((bent_tip_m - Eigen::Vector3d{0.0, 1.0, 5.0}).norm() < 1e-12);
}

TEST_CASE("touch: boxes side by side, face to face and edge over edge -> overlap or not") {
  const Eigen::Vector3d half_m{1.0, 1.0, 1.0};
  const auto straight = Eigen::Quaterniond::Identity();
  const PlacedBox a = placed(half_m, {0.0, 0.0, 0.0}, straight);
  CHECK(touch(a, placed(half_m, {2.0, 0.0, 0.0}, straight)));
  CHECK_FALSE(touch(a, placed(half_m, {2.001, 0.0, 0.0}, straight)));
  const Eigen::Quaterniond on_edge{Eigen::AngleAxisd{std::numbers::pi / 4.0, Eigen::Vector3d::UnitY()}};
  CHECK(touch(a, placed(half_m, {1.0 + std::sqrt(2.0) - 1e-6, 0.0, 0.0}, on_edge)));
  CHECK_FALSE(touch(a, placed(half_m, {1.0 + std::sqrt(2.0) + 1e-6, 0.0, 0.0}, on_edge)));
  // Two edges that cross: only the product of both separates them.
  const Eigen::Quaterniond lower{Eigen::AngleAxisd{std::numbers::pi / 4.0, Eigen::Vector3d::UnitX()}};
  const PlacedBox roof = placed(half_m, {0.0, 0.0, 0.0}, lower);
  CHECK(touch(roof, placed(half_m, {0.0, 0.0, 2.0 * std::sqrt(2.0) - 1e-6}, on_edge)));
  CHECK_FALSE(touch(roof, placed(half_m, {0.0, 0.0, 2.0 * std::sqrt(2.0) + 1e-6}, on_edge)));
}

TEST_CASE("touch: random boxes -> touch exactly if there is no gap, in any order and frame") {
  int touching = 0;
  for (std::uint64_t world = 0; world < 300; ++world) {
    CAPTURE(world);
    Rng rng{world, Stream::user};
    const auto half_m = [&] { return Eigen::Vector3d{rng.uniform(0.05, 1.0), rng.uniform(0.05, 1.0), rng.uniform(0.05, 1.0)}; };
    const PlacedBox a = placed(half_m(), drawn_point(rng, 1.0), drawn_turn(rng));
    const PlacedBox b = placed(half_m(), drawn_point(rng, 1.0), drawn_turn(rng));
    const double gap_m = distance_m(a, b);
    if (gap_m > 1e-9 && gap_m < 1e-3) continue;  // what takes the comparison too long to decide
    CHECK(touch(a, b) == (gap_m < 1e-9));
    CHECK(touch(b, a) == touch(a, b));
    const Eigen::Matrix3d turn = drawn_turn(rng).toRotationMatrix();
    const PlacedBox turned_a{turn * a.centre_m, turn * a.half_edges_m, a.radius_m};
    const PlacedBox turned_b{turn * b.centre_m, turn * b.half_edges_m, b.radius_m};
    CHECK(touch(turned_a, turned_b) == touch(a, b));
    touching += touch(a, b) ? 1 : 0;
  }
  CHECK(touching > 75);
  CHECK(touching < 225);
}

TEST_CASE("touch: arm bent by its joint -> reaches a wall or another robot") {
  const RobotModel robot = arm();
  const std::vector<double> up{-std::numbers::pi / 2.0};
  const auto boxes = [&](double x_m, const std::vector<double>& angles_rad) {
    return placed_boxes(robot, {{x_m, 0.0, 0.0}, Eigen::Quaterniond::Identity()}, angles_rad);
  };
  CHECK(touch_wall(boxes(7.0, {0.0}), 10.0));
  CHECK_FALSE(touch_wall(boxes(6.99, {0.0}), 10.0));
  CHECK_FALSE(touch_wall(boxes(7.0, up), 10.0));
  CHECK(touch_wall(boxes(-9.0, up), 10.0));
  CHECK(touch(boxes(0.0, {0.0}), boxes(4.0, up)));
  CHECK_FALSE(touch(boxes(0.0, up), boxes(4.0, up)));
}
