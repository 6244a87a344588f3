// SPDX-License-Identifier: MIT
// A robot without sides turns by bending and lives in an ecology, in both engines.
#include <doctest/doctest.h>

#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/control/steering/bending_steering.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/perception/sensors/joint_angles.hpp>
#include <trophic/perception/sensors/tilt.hpp>
#include <trophic/perception/sensors/touch.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;

TEST_CASE_TEMPLATE("snake: walks ahead, and target angles to a side -> turns to that side", Engine, backend::Mujoco,
                   backend::Ode) {
  const RobotModel robot = load_robot("snake");
  std::vector<Pose> starts;
  for (const double y_m : {-4.0, 0.0, 4.0}) starts.push_back({.position_m = {0.0, y_m, robot.rest_height_m}});
  Engine engine{robot, load_arena("walled_square"), starts, Physics{}, {}};
  locomotion::Locomotion<control::steering::BendingSteering> walk{robot, load_gait("snake_steered"), {}, 3, {}};
  std::array<double, 3> turned_rad{};
  std::array<double, 3> before_rad{};
  double ahead_m = 0.0;
  for (int second = 0; second < 50; ++second) {
    const Eigen::Vector3d from_m = engine.pose(1).position_m;
    walk.advance(engine, 60, std::array{0.7, 0.0, -0.7});
    for (std::size_t i = 0; i < 3; ++i) {
      const double heading_rad = ground_pose(engine.pose(i), robot.forward_rad).heading_rad;
      turned_rad[i] += wrap_angle(heading_rad - before_rad[i]);
      before_rad[i] = heading_rad;
      CHECK(std::isfinite(heading_rad));
    }
    const Eigen::Vector3d way_m = engine.pose(1).position_m - from_m;
    ahead_m += way_m.x() * std::cos(before_rad[1]) + way_m.y() * std::sin(before_rad[1]);
  }
  CHECK(turned_rad[0] < turned_rad[1] - 0.5);
  CHECK(turned_rad[2] > turned_rad[1] + 0.5);
  CHECK(ahead_m > 1.5);
}

namespace {

namespace sensors = perception::sensors;
using Bending = with_steering<rules::Paper, control::steering::BendingSteering>;
using Feeling = with_brain<with_sensors<Bending, sensors::List<sensors::JointAngles<5>, sensors::Tilt, sensors::Touch>>,
                           control::brain::FeedForwardBrain>;

/// The largest value of each input.
struct Inputs {
  std::array<double, 8> most{};
  [[nodiscard]] bool wants_decisions() const { return true; }
  void on_decision(const observe::DecisionRecord& record, const View&) {
    for (std::size_t i = 0; i < most.size(); ++i) most[i] = std::max(most[i], record.inputs[i]);
  }
};

}  // namespace

TEST_CASE_TEMPLATE("snake: ecology -> six live, walk, and sense their bodies", Engine, backend::Mujoco, backend::Ode) {
  Experiment<Feeling> params{.seed = 1};
  params.ecology.robot = "snake";
  params.ecology.robots = 6;
  params.rules.community.predators = 3;
  Ecology ecology{params, typename Engine::Params{}};
  const std::vector<GroundPose> starts{ecology.view().poses.begin(), ecology.view().poses.end()};
  Inputs inputs;
  ecology.run_until(20.0, inputs);
  for (std::size_t joint = 0; joint < 5; ++joint) CHECK(inputs.most[joint] > 0.1);
  CHECK(inputs.most[5] > 0.0);
  double way_m = 0.0;
  for (std::size_t i = 0; i < 6; ++i) way_m += distance_m(starts[i], ecology.view().poses[i]);
  CHECK(way_m > 6 * 0.1);
}

TEST_CASE("senses of the body: backend without joints -> refused") {
  Experiment<with_steering<Feeling, control::steering::TargetedSteering>> params;
  const auto make = [&] { Ecology{params, backend::Kinematic::Params{}}; };
  CHECK_THROWS_WITH_AS(make(),
                       "rules.sensors = joint_angles + tilt + touch on backend kinematic: must be a backend with joints, whose "
                       "robots have joint angles, tilt and touch",
                       std::invalid_argument);
}
