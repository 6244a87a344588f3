// SPDX-License-Identifier: MIT
// Audit of the robots in models/ against the module table; every expected number was computed by hand from that table.
#include <doctest/doctest.h>

#include <map>
#include <string>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;

namespace {

void check_near(const Eigen::Vector3d& value, const Eigen::Vector3d& expected, double tolerance = 1e-12) {
  CAPTURE(value.transpose());
  CAPTURE(expected.transpose());
  CHECK((value - expected).norm() <= tolerance);
}

/// Axis of a hinge in the root frame, all angles 0.
Eigen::Vector3d axis_in_root(const RobotModel& robot, std::size_t hinge) {
  Eigen::Vector3d axis = robot.hinges[hinge].axis;
  for (std::size_t link = hinge + 1; link != 0; link = static_cast<std::size_t>(robot.links[link].parent)) {
    axis = robot.links[link].rotation * axis;
  }
  return axis;
}

}  // namespace

TEST_CASE("robot build: spider -> masses of the module table") {
  const RobotModel spider = load_robot("spider");
  REQUIRE(spider.links.size() == 5);
  CHECK(spider.links[0].mass_kg == doctest::Approx(0.250 + 4 * 0.011).epsilon(1e-14));
  for (std::size_t leg = 1; leg < 5; ++leg) {
    CHECK(spider.links[leg].mass_kg == doctest::Approx(0.058 + 0.020 + 0.030).epsilon(1e-14));
  }
  CHECK(spider.mass_kg() == doctest::Approx(0.726).epsilon(1e-14));
  std::map<std::string, int> parts;
  for (const Link& link : spider.links) {
    for (const Box& box : link.boxes) ++parts[box.part];
  }
  CHECK(parts ==
        std::map<std::string, int>{{"core", 1}, {"hinge_frame", 4}, {"servo_body", 4}, {"servo_plate", 4}, {"brick", 4}});
}

TEST_CASE("robot build: spider -> inertias by the parallel axis theorem") {
  const RobotModel spider = load_robot("spider");
  check_near(spider.links[0].centre_of_mass_m, {0, 0, 0});
  check_near(spider.links[0].inertia_kgm2.diagonal(), {0.00031281775349006083, 0.00031281775349006083, 0.000462823030104485},
             1e-16);
  for (std::size_t leg = 1; leg < 5; ++leg) {
    check_near(spider.links[leg].centre_of_mass_m, {0.0409703125, 0, 0});
    check_near(spider.links[leg].inertia_kgm2.diagonal(),
               {4.2943886097656254e-05, 0.00012075938233007815, 0.00013229281842773438}, 1e-16);
  }
  for (const Link& link : spider.links) {
    Eigen::Matrix3d products = link.inertia_kgm2;
    products.diagonal().setZero();
    CHECK(products.norm() < 1e-16);
  }
}

TEST_CASE("robot build: spider -> hinges in the order front, back, left, right") {
  const RobotModel spider = load_robot("spider");
  REQUIRE(spider.hinges.size() == 4);
  const std::vector<std::string> names{"front", "back", "left", "right"};
  const std::vector<Eigen::Vector3i> cells{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  // Front and left legs lift, right and back legs sweep.
  const std::vector<Eigen::Vector3d> axes{{0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(spider.hinges[i].name == names[i]);
    CHECK(spider.links[i + 1].name == names[i]);
    CHECK(spider.links[i + 1].parent == 0);
    CHECK(spider.hinges[i].grid_position == cells[i]);
    check_near(axis_in_root(spider, i), axes[i], 1e-15);
    // Core face 0.0445, servo body 0.052525 beyond it, joint 0.018 before that.
    check_near(spider.links[i + 1].offset_m, 0.079025 * cells[i].cast<double>(), 1e-15);
    CHECK(spider.hinges[i].range_rad == 1.047197551);
    CHECK(spider.hinges[i].servo.position_gain == 5.0);
    CHECK(spider.hinges[i].servo.velocity_gain == 0.05);
    CHECK(spider.hinges[i].servo.target_limit_rad == 1.0);
  }
  const std::vector<std::vector<std::size_t>> all_pairs{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  CHECK(spider.hinge_neighbours == all_pairs);
}

TEST_CASE("robot build: spider -> positions of the boxes") {
  const RobotModel spider = load_robot("spider");
  const Link& core = spider.links[0];
  check_near(core.boxes[0].half_extents_m, {0.0445, 0.0445, 0.03015});
  check_near(core.boxes[1].centre_m, {0.0535, 0, 0});   // front hinge frame
  check_near(core.boxes[4].centre_m, {0, -0.0535, 0});  // right hinge frame
  check_near(core.boxes[4].orientation * Eigen::Vector3d::UnitY(), {0, 0, 1}, 1e-15);
  const Link& leg = spider.links[1];
  check_near(leg.boxes[0].centre_m, {0.018, 0, 0});
  check_near(leg.boxes[1].centre_m, {0.04815, 0, 0});
  check_near(leg.boxes[2].centre_m, {0.080593125, 0, 0});
  check_near(leg.boxes[2].half_extents_m, {0.031443125, 0.031443125, 0.03015});
}

TEST_CASE("robot build: spider -> size and forward axis") {
  const RobotModel spider = load_robot("spider");
  // The bricks of the sweeping legs lie on their side: half of 0.06288625.
  CHECK(spider.rest_height_m == doctest::Approx(0.031443125).epsilon(1e-12));
  CHECK(spider.bounding_radius_m == doctest::Approx(0.1992323788243805).epsilon(1e-12));
  CHECK(spider.forward_rad == doctest::Approx(0.78539816339744828).epsilon(1e-15));
  CHECK(spider.friction == 1.0);
}

TEST_CASE("robot build: released spider -> root link by density, legs unchanged") {
  const RobotModel released = load_robot("spider_released");
  const RobotModel spider = load_robot("spider");
  // 1000 kg/m^3 * (0.089 * 0.089 * 0.0603 + 4 * 0.018 * 0.053 * 0.0165891)
  CHECK(released.links[0].mass_kg == doctest::Approx(0.5409403056).epsilon(1e-12));
  CHECK(released.mass_kg() == doctest::Approx(0.9729403056).epsilon(1e-12));
  check_near(released.links[0].inertia_kgm2.diagonal(), {0.0005636603226984711, 0.0005636603226984711, 0.0008215957078373476},
             1e-15);
  for (std::size_t leg = 1; leg < 5; ++leg) {
    CHECK(released.links[leg].mass_kg == spider.links[leg].mass_kg);
    CHECK(released.links[leg].inertia_kgm2 == spider.links[leg].inertia_kgm2);
  }
}

TEST_CASE("robot build: gecko -> six hinges, two of them in the spine") {
  const RobotModel gecko = load_robot("gecko");
  const std::vector<std::string> names{
      "back", "back.front.front", "back.front.front.front.left", "back.front.front.front.right", "left", "right"};
  const std::vector<Eigen::Vector3i> cells{{-1, 0, 0}, {-3, 0, 0}, {-4, -1, 0}, {-4, 1, 0}, {0, 1, 0}, {0, -1, 0}};
  const std::vector<Eigen::Vector3d> axes{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, {1, 0, 0}};
  const std::vector<int> parents{-1, 0, 1, 2, 2, 0, 0};
  const std::vector<std::vector<std::size_t>> neighbours{{1, 4, 5}, {0, 2, 3}, {1, 3}, {1, 2}, {0, 5}, {0, 4}};
  REQUIRE(gecko.hinges.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    CAPTURE(i);
    CHECK(gecko.hinges[i].name == names[i]);
    CHECK(gecko.hinges[i].grid_position == cells[i]);
    check_near(axis_in_root(gecko, i), axes[i], 1e-15);
  }
  for (std::size_t i = 0; i < 7; ++i) CHECK(gecko.links[i].parent == parents[i]);
  CHECK(gecko.hinge_neighbours == neighbours);
  // Core, six hinges, six bricks.
  CHECK(gecko.mass_kg() == doctest::Approx(0.250 + 6 * (0.011 + 0.058 + 0.020 + 0.030)).epsilon(1e-14));
  CHECK(gecko.rest_height_m == doctest::Approx(0.03015).epsilon(1e-12));
}

TEST_CASE("robot build: any joint angles -> boxes within the bounding sphere") {
  Rng rng{1, Stream::user};
  for (const char* name : {"spider", "gecko"}) {
    const RobotModel robot = load_robot(name);
    double farthest_m = 0.0;
    for (int sample = 0; sample < 2000; ++sample) {
      std::vector<Eigen::Isometry3d> frames(robot.links.size(), Eigen::Isometry3d::Identity());
      for (std::size_t i = 0; i < robot.links.size(); ++i) {
        const Link& link = robot.links[i];
        if (i > 0) {
          const Hinge& hinge = robot.hinges[i - 1];
          frames[i] = frames[static_cast<std::size_t>(link.parent)] * Eigen::Translation3d{link.offset_m} * link.rotation *
                      Eigen::AngleAxisd{rng.uniform(-hinge.range_rad, hinge.range_rad), hinge.axis};
        }
        for (const Box& box : link.boxes) {
          for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d sign{corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0};
            const Eigen::Vector3d point = box.centre_m + box.orientation * sign.cwiseProduct(box.half_extents_m);
            farthest_m = std::max(farthest_m, (frames[i] * point).norm());
          }
        }
      }
    }
    CAPTURE(name);
    CHECK(farthest_m <= robot.bounding_radius_m);
    CHECK(farthest_m > 0.7 * robot.bounding_radius_m);
  }
}
