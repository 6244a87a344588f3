// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <support/temporary_folder.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/habitat/validate_robot.hpp>

using namespace trophic;

namespace {

std::string broken(const std::function<void(RobotModel&)>& change) {
  RobotModel robot = load_robot("spider");
  change(robot);
  return test::message_of<std::invalid_argument>([&] { validate(robot); });
}

}  // namespace

TEST_CASE("validate robot: valid robot -> accepted") {
  CHECK_NOTHROW(validate(load_robot("gecko")));
}

TEST_CASE("validate robot: broken invariant -> error with robot, field, value and rule") {
  CHECK(broken([](RobotModel& r) { r.hinges.pop_back(); }) == "robot spider: links.size() = 5: must be hinges.size() + 1 = 4");
  CHECK(broken([](RobotModel& r) { r.hinge_neighbours.pop_back(); }) ==
        "robot spider: hinge_neighbours.size() = 3: must be hinges.size() = 4");
  CHECK(broken([](RobotModel& r) { r.links[2].parent = 2; }) == "robot spider: links[2].parent = 2: must be >= 0 and < 2");
  CHECK(broken([](RobotModel& r) { r.links[0].parent = 0; }) == "robot spider: links[0].parent = 0: must be -1");
  CHECK(broken([](RobotModel& r) { r.links[1].mass_kg = 0.0; }) == "robot spider: links[1].mass_kg = 0: must be > 0");
  CHECK(broken([](RobotModel& r) { r.links[1].mass_kg = 0.5; }) ==
        "robot spider: links[1].mass_kg = 0.5: must be the sum of its boxes, 0.108");
  CHECK(broken([](RobotModel& r) { r.links[1].boxes[0].mass_kg = std::numeric_limits<double>::quiet_NaN(); }) ==
        "robot spider: links[1].servo_body mass_kg = nan: must be > 0");
  CHECK(broken([](RobotModel& r) { r.links[1].inertia_kgm2 = Eigen::Vector3d(1, 1, 3).asDiagonal(); }) ==
        "robot spider: links[1].inertia_kgm2 largest principal moment = 3: must be <= the sum of the other two");
  CHECK(broken([](RobotModel& r) { r.links[1].inertia_kgm2(0, 1) = 1.0; }) ==
        "robot spider: links[1].inertia_kgm2: must be finite and symmetric");
  CHECK(broken([](RobotModel& r) { r.hinges[1].name = "front"; }) == "robot spider: hinges[1].name = front: must be unique");
  CHECK(broken([](RobotModel& r) { r.hinges[1].axis *= 2.0; }) == "robot spider: hinges[1].axis norm = 2: must be 1");
  CHECK(broken([](RobotModel& r) { r.hinges[1].range_rad = 0.0; }) == "robot spider: hinges[1].range_rad = 0: must be > 0");
  CHECK(broken([](RobotModel& r) { r.hinges[3].servo.target_limit_rad = -1.0; }) ==
        "robot spider: hinges[3].servo.target_limit_rad = -1: must be > 0");
  CHECK(broken([](RobotModel& r) { r.hinge_neighbours[0] = {2, 1}; }) == "robot spider: hinge_neighbours[0]: must be ascending");
  CHECK(broken([](RobotModel& r) { r.hinge_neighbours[0] = {0}; }) ==
        "robot spider: hinge_neighbours[0] = 0: must be another hinge that lists this one too");
  CHECK(broken([](RobotModel& r) { r.hinge_neighbours[0] = {}; }) ==
        "robot spider: hinge_neighbours[1] = 0: must be another hinge that lists this one too");
  CHECK(broken([](RobotModel& r) { r.links[1].boxes[0].centre_m.x() = std::numeric_limits<double>::infinity(); }) ==
        "robot spider: links[1].servo_body centre_m: must be finite");
  CHECK(broken([](RobotModel& r) { r.links[1].boxes[0].orientation.coeffs() *= 2.0; }) ==
        "robot spider: links[1].servo_body orientation norm = 2: must be 1");
  CHECK(broken([](RobotModel& r) {
          r.bounding_radius_m = 0.19;
        }).starts_with("robot spider: bounding_radius_m = 0.19: must be >= 0.199"));
  CHECK(broken([](RobotModel& r) { r.friction = -0.1; }) == "robot spider: friction = -0.1: must be >= 0 and <= 10");
  CHECK(broken([](RobotModel& r) { r.rest_height_m = 0.0; }) == "robot spider: rest_height_m = 0: must be > 0");
}
