// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <trophic/control/locomotion/steerable.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/body/limits.hpp>
#include <trophic/habitat/body/variation.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <unit/habitat/hand_bodies.hpp>

using namespace trophic;
using namespace trophic::body;

namespace {

RobotModel built(const ModuleTree& tree, double forward_deg = 0.0) {
  Design design;
  design.name = "drawn";
  design.forward_deg = forward_deg;
  design.modules = tree;
  return build(design);
}

std::string why_not(const char* plan, const Limits& limits = {}, double forward_deg = 0.0) {
  const ModuleTree tree = read_plan(plan);
  return refusal(tree, built(tree, forward_deg), limits).value_or("viable");
}

}  // namespace

TEST_CASE("body limits: hand-drawn plans -> viable, or the first reason why not") {
  CHECK(why_not(hand::spider, {}, 45.0) == "viable");
  CHECK(why_not("core") == "0 hinges: must be >= 1");
  CHECK(why_not("core", {.fewest_hinges = 0}) == "viable");
  CHECK(why_not(hand::spider, {.most_modules = 8}) == "9 modules: must be <= 8");
  CHECK(why_not(hand::spider, {.most_hinges = 3}) == "4 hinges: must be <= 3");
  CHECK(why_not(hand::snake) == "no hinge on the left or right side: must have one to be steerable");
  CHECK(why_not(hand::snake, {}, 90.0) == "viable");
  CHECK(why_not(hand::snake, {}, 45.0) == "viable");
}

TEST_CASE("body limits: shipped robots -> no overlap") {
  for (const char* name : {"spider", "gecko", "spider_released"}) {
    CAPTURE(name);
    CHECK(overlapping_links(load_robot(name)).empty());
  }
}

TEST_CASE("body limits: a leg pushed into another -> the links that overlap") {
  RobotModel robot = load_robot("spider");
  robot.links[2].offset_m = robot.links[1].offset_m;
  robot.links[2].rotation = robot.links[1].rotation;
  CHECK(overlapping_links(robot) == "front and back");
}

TEST_CASE("body limits: random trees -> boxes overlap in a few, those that turn to both sides have sides") {
  int overlap = 0;
  int steered = 0;
  int one_sided = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Rng rng{seed, Stream::user};
    const RobotModel robot = built(random_tree(21, rng));
    overlap += !overlapping_links(robot).empty();
    bool can_be_steered = true;
    try {
      locomotion::check_steerable(robot, control::steering::TargetedSteering{});
    } catch (const std::invalid_argument&) {
      can_be_steered = false;
    }
    CHECK((!can_be_steered || has_sides(robot)));
    steered += can_be_steered;
    one_sided += !can_be_steered && has_sides(robot);
  }
  CHECK(steered > 100);
  CHECK(one_sided > 0);
  CHECK(overlap > 0);
  CHECK(overlap < 60);
}
