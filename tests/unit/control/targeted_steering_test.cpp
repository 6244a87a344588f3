// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::control::steering;

namespace {

std::vector<Side> sides_of(const RobotModel& robot) {
  std::vector<Side> sides;
  for (const HingePlace& hinge : hinge_places(robot)) sides.push_back(hinge.side);
  return sides;
}

}  // namespace

TEST_CASE("sides: spider -> x - y < 0 left, x - y > 0 right") {
  CHECK(sides_of(load_robot("spider")) == std::vector<Side>{Side::right, Side::left, Side::left, Side::right});
}

TEST_CASE("sides: gecko -> legs by their position, spine in the middle") {
  CHECK(sides_of(load_robot("gecko")) ==
        std::vector<Side>{Side::middle, Side::middle, Side::right, Side::left, Side::left, Side::right});
}

TEST_CASE("targeted steering: target angle alpha -> delta = ((pi - |alpha|) / pi)^2") {
  const TargetedSteering steering;
  CHECK(steering.slowing(0.0) == 1.0);
  CHECK(steering.slowing(0.7) == doctest::Approx(0.6040135393274385).epsilon(1e-14));
  CHECK(steering.slowing(-0.7) == steering.slowing(0.7));
  CHECK(steering.slowing(std::numbers::pi / 2.0) == 0.25);
  CHECK(steering.slowing(std::numbers::pi) == 0.0);
  CHECK(steering.slowing(4.0) == 0.0);
  const TargetedSteering fourth{{.exponent = 4.0}};
  CHECK(fourth.slowing(0.7) == doctest::Approx(0.6040135393274385 * 0.6040135393274385).epsilon(1e-14));
}

TEST_CASE("targeted steering: positive target angle -> right side slower, negative -> left, 0 -> none") {
  const TargetedSteering steering;
  const std::vector<HingePlace> hinges{{Side::right}, {Side::left}, {Side::middle}, {Side::right}};
  const std::vector<double> walk{1.0, -0.5, 0.25, -1.0};
  const double delta = steering.slowing(0.7);
  std::vector<double> targets_rad = walk;
  steering.steer(0.0, hinges, targets_rad);
  CHECK(targets_rad == walk);
  steering.steer(0.7, hinges, targets_rad);
  CHECK(targets_rad == std::vector<double>{delta, -0.5, 0.25, -delta});
  targets_rad = walk;
  steering.steer(-0.7, hinges, targets_rad);
  CHECK(targets_rad == std::vector<double>{1.0, -0.5 * delta, 0.25, -1.0});
}
