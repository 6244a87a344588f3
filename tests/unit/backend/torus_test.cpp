// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/backend/torus.hpp>
#include <trophic/perception/adversary.hpp>

using namespace trophic;
using backend::Torus;

namespace {

constexpr double half_side_m = 5.0;

/// One point at a place with a heading.
Torus at(double x_m, double y_m, double heading_rad, const Torus::Params& params = {}) {
  Arena arena;
  arena.half_side_m = half_side_m;
  const Pose start{.position_m = {x_m, y_m, 0.0},
                   .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{heading_rad, Eigen::Vector3d::UnitZ()}}};
  return Torus{RobotModel{}, arena, std::array{start}, Physics{}, params};
}

}  // namespace

TEST_CASE("torus: a step -> turns clockwise by the target angle, then walks straight") {
  Torus points = at(0.0, 0.0, std::numbers::pi / 2.0, {.speed_m_s = 2.0});
  points.set_target_angle(0, std::numbers::pi / 2.0);
  points.advance_to(1.0);
  CHECK(points.pose(0).position_m.x() == doctest::Approx(2.0));
  CHECK(points.pose(0).position_m.y() == doctest::Approx(0.0));
}

TEST_CASE("torus: who leaves on one side comes in on the other") {
  Torus points = at(4.5, -4.5, -std::numbers::pi / 4.0);
  points.advance_to(1.0);
  CHECK(points.pose(0).position_m.x() == doctest::Approx(4.5 + std::sqrt(0.5) - 10.0));
  CHECK(points.pose(0).position_m.y() == doctest::Approx(-4.5 - std::sqrt(0.5) + 10.0));
}

TEST_CASE("torus: distances in a view -> the shortest, over the edges too") {
  test::HandPopulation robots{{{.x_m = 4.5}, {.x_m = -4.5, .y_m = 1.0}}};
  View view = robots.view();
  CHECK(view.distance_m(0, 1) == doctest::Approx(std::sqrt(82.0)));
  view.space.period_m = 2.0 * half_side_m;
  CHECK(view.distance_m(0, 1) == doctest::Approx(std::sqrt(2.0)));
  CHECK(view.within(robots.poses[0], 1.5).size() == 2);
  CHECK(view.closest(0, [](const Individual&) { return true; }, {.within_m = 1.5}) == BodyIndex{1});
}

TEST_CASE("torus: bearings of a sighting -> over the nearest edge") {
  test::HandPopulation robots{{{.x_m = 4.5}, {.species = test::predator, .x_m = -4.5, .y_m = -1.0}}};
  View view = robots.view();
  view.space.period_m = 2.0 * half_side_m;
  const auto seen = perception::adversary(0, view, [](BodyIndex, BodyIndex) { return true; });
  REQUIRE(seen);
  CHECK(seen->bearing_rad == doctest::Approx(std::numbers::pi / 4.0));
}

TEST_CASE("torus: start outside the square, numbers out of bounds -> errors that name them") {
  CHECK_THROWS_WITH_AS(at(5.5, 0.0, 0.0), "start pose 0 at (5.5, 0): must be finite and within +-5", std::invalid_argument);
  CHECK_THROWS_AS(at(0.0, 0.0, 0.0, {.timestep_s = 0.0}), std::invalid_argument);
}
