// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/habitat/obstacle.hpp>
#include <trophic/habitat/touch.hpp>
#include <trophic/support/rng.hpp>

using namespace trophic;

namespace {

constexpr Obstacle pillar{.x_m = 2.0, .y_m = 0.0, .to_x_m = 2.0, .to_y_m = 0.0, .radius_m = 0.5};
constexpr Obstacle wall{.x_m = 1.0, .y_m = -1.0, .to_x_m = 1.0, .to_y_m = 1.0, .radius_m = 0.1};

}  // namespace

TEST_CASE("obstacle: distance -> to the surface, negative inside") {
  CHECK(distance_m(pillar, 0.0, 0.0) == 1.5);
  CHECK(distance_m(pillar, 2.0, 0.0) == -0.5);
  CHECK(distance_m(wall, 0.0, 0.5) == doctest::Approx(0.9));
  CHECK(distance_m(wall, 1.0, 2.0) == doctest::Approx(0.9));
}

TEST_CASE("obstacle: ray -> where small steps along it first arrive") {
  Rng rng{3, Stream::user};
  int hits = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Obstacle one{.x_m = rng.uniform(-2.0, 2.0),
                       .y_m = rng.uniform(-2.0, 2.0),
                       .to_x_m = rng.uniform(-2.0, 2.0),
                       .to_y_m = rng.uniform(-2.0, 2.0),
                       .radius_m = rng.uniform(0.05, 0.5)};
    const GroundPose from{rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), rng.uniform(-std::numbers::pi, std::numbers::pi)};
    double least_m = 1e9;
    std::optional<double> walked;
    for (double at_m = 0.0; at_m < 8.0 && !walked; at_m += 1e-3) {
      const double gap_m =
          distance_m(one, from.x_m + at_m * std::cos(from.heading_rad), from.y_m + at_m * std::sin(from.heading_rad));
      least_m = std::min(least_m, gap_m);
      if (gap_m <= 0.0) walked = at_m;
    }
    const std::optional<double> hit = ray_m(one, from, std::cos(from.heading_rad), std::sin(from.heading_rad));
    CAPTURE(trial);
    if (walked) {
      ++hits;
      REQUIRE(hit);
      CHECK(*hit == doctest::Approx(*walked).epsilon(0.01).scale(0.1));
    } else if (least_m > 0.01) {
      CHECK_FALSE(hit);
    }
  }
  CHECK(hits > 50);
}

TEST_CASE("obstacle: box -> touches one that it overlaps, seen from above, and not one below it") {
  const auto box_at = [](double x_m, double z_m, double turn_rad) {
    const Eigen::Matrix3d axes = Eigen::AngleAxisd{turn_rad, Eigen::Vector3d::UnitZ()}.toRotationMatrix();
    return PlacedBox{.centre_m = {x_m, 0.2, z_m},
                     .half_edges_m = axes * Eigen::Vector3d{0.3, 0.2, 0.1}.asDiagonal(),
                     .radius_m = Eigen::Vector3d{0.3, 0.2, 0.1}.norm()};
  };
  CHECK(touch(box_at(0.61, 0.1, 0.0), wall));
  CHECK_FALSE(touch(box_at(0.59, 0.1, 0.0), wall));
  CHECK(touch(box_at(0.69, 0.1, std::numbers::pi / 2), wall) == false);
  CHECK(touch(box_at(0.71, 0.1, std::numbers::pi / 2), wall));
  CHECK(touch(box_at(1.0, 0.1, 0.3), wall));
  CHECK_FALSE(touch(box_at(1.0, 0.61, 0.3), wall));
  CHECK_FALSE(touch(box_at(1.0, 0.1, 0.0), pillar));
  CHECK(touch(box_at(1.3, 0.1, 0.0), pillar));
}
