// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/toy_backend.hpp>
#include <trophic/control/locomotion/steerable.hpp>
#include <trophic/control/steering/bending_steering.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using namespace trophic::control::steering;
using namespace trophic::locomotion;

namespace {

/// The gecko with all hinges at its core.
RobotModel snake() {
  RobotModel robot = load_robot("gecko");
  robot.name = "snake";
  for (Hinge& hinge : robot.hinges) hinge.grid_position.setZero();
  return robot;
}

/// Knows no sides.
struct SlowsAll {
  static constexpr std::string_view name = "slows_all";
  void steer(double, std::span<const HingePlace>, std::span<double> targets_rad) const {
    for (double& target_rad : targets_rad) target_rad *= 0.5;
  }
};

/// Adds to each target instead of scaling it.
struct Leans {
  static constexpr std::string_view name = "leans";
  void steer(double target_angle_rad, std::span<const HingePlace>, std::span<double> targets_rad) const {
    for (double& target_rad : targets_rad) target_rad += 0.1 * target_angle_rad;
  }
};

template <class Act>
std::string refusal(Act&& act) {
  try {
    act();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

template <class Rules>
std::string ecology_refusal(RobotModel robot, Experiment<Rules> params = {}) {
  params.ecology.robots = 1;
  params.rules.community.predators = 1;
  Habitat habitat{.robot = std::move(robot), .arena = {}, .gait = load_gait("gecko_steered")};
  return refusal([&] { Ecology<Rules>{params, test::ToyBackend::Params{}, habitat}; });
}

}  // namespace

TEST_CASE("steerable: shipped robots -> accepted") {
  for (const char* name : {"spider", "gecko"}) {
    CHECK(refusal([&] { check_steerable(load_robot(name), TargetedSteering{}); }) == "");
  }
}

TEST_CASE("steerable: all hinges in the middle -> rejected, unless the steering needs no sides") {
  CHECK(
      refusal([] { check_steerable(snake(), TargetedSteering{}); }) ==
      "ecology.robot = snake with rules.steering = targeted_steering: cannot be steered to both sides: a turn moves no hinge, or "
      "it moves the same hinges as the opposite turn (0 left, 0 right, 6 middle); bending_steering needs no hinges at the sides");
  CHECK(refusal([] { check_steerable(snake(), Leans{}); }) == "");
}

TEST_CASE("steerable: hinges on one side only -> rejected, for one of the turns is dead") {
  RobotModel robot = snake();
  robot.hinges.front().grid_position = {2, 1, 0};
  CHECK(refusal([&] { check_steerable(robot, TargetedSteering{}); }).find("(1 left, 0 right, 5 middle)") != std::string::npos);
}

TEST_CASE("steerable: a snake -> bends, in either frame") {
  RobotModel robot = load_robot("snake");
  CHECK(refusal([&] { check_steerable(robot, BendingSteering{}); }) == "");
  CHECK_FALSE(refusal([&] { check_steerable(robot, TargetedSteering{}); }).empty());
  robot.forward_rad = std::numbers::pi / 4.0;
  CHECK(refusal([&] { check_steerable(robot, BendingSteering{}); }) == "");
  CHECK_FALSE(refusal([&] { check_steerable(robot, TargetedSteering{}); }).empty());
}

TEST_CASE("steerable: steering with no effect, or the same for both turns -> rejected") {
  const RobotModel gecko = load_robot("gecko");
  CHECK(refusal([&] { check_steerable(gecko, TargetedSteering{{.exponent = 0.0}}); }).find("cannot be steered") !=
        std::string::npos);
  CHECK(refusal([&] { check_steerable(gecko, SlowsAll{}); }).find("rules.steering = slows_all") != std::string::npos);
}

TEST_CASE("steerable: ecology with jointed robots -> error before the run") {
  CHECK(ecology_refusal<rules::Paper>(load_robot("gecko")) == "");
  CHECK(ecology_refusal<rules::Paper>(snake()).starts_with("ecology.robot = snake with rules.steering = targeted_steering"));
  CHECK(ecology_refusal<with_steering<rules::Paper, Leans>>(snake()) == "");
  CHECK(ecology_refusal<with_steering<rules::Paper, SlowsAll>>(load_robot("gecko")).find("slows_all") != std::string::npos);
  Experiment<rules::Paper> params;
  params.rules.steering.exponent = 0.0;
  CHECK(ecology_refusal<rules::Paper>(load_robot("gecko"), params).find("cannot be steered") != std::string::npos);
}
