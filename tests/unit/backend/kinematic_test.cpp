// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <numbers>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>

using namespace trophic;
using trophic::backend::Kinematic;
using trophic::test::message_of;

namespace {

Pose standing(double x_m, double y_m, double yaw_rad) {
  return {.position_m = {x_m, y_m, 0.0}, .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{yaw_rad, Eigen::Vector3d::UnitZ()}}};
}

constexpr MeasuredWalk slow{.speed_m_s = 0.05, .turn_rate_per_rad = 0.1};

Kinematic world(const std::vector<Pose>& starts, const Kinematic::Params& params = {}, const MeasuredWalk& walk = slow,
                const char* robot_name = "spider") {
  RobotModel robot = load_robot(robot_name);
  robot.walk = walk;
  return {robot, load_arena("walled_square"), starts, Physics{}, params};
}

const double forward_rad = std::numbers::pi / 4.0;

}  // namespace

TEST_CASE("kinematic: no target angle -> straight walk along the forward axis") {
  Kinematic backend = world({standing(1.0, 2.0, -forward_rad)});
  backend.advance_to(20.0);
  const GroundPose at = ground_pose(backend.pose(0), forward_rad);
  CHECK(at.x_m == doctest::Approx(2.0).epsilon(1e-12));
  CHECK(at.y_m == doctest::Approx(2.0).epsilon(1e-12));
  CHECK(std::abs(at.heading_rad) < 1e-12);
  CHECK(backend.pose(0).position_m.z() == load_robot("spider").rest_height_m);
}

TEST_CASE("kinematic: positive target angle -> right turn on an exact circle") {
  const double rate_rad_s = 0.2 * 0.5;
  const double radius_m = 0.05 / rate_rad_s;
  Kinematic backend = world({standing(0.0, 0.0, -forward_rad)}, {.turn_scale = 2.0});
  backend.set_target_angle(0, 0.5);
  for (int tick = 1; tick <= 100; ++tick) {
    const double time_s = 0.5 * tick;
    backend.advance_to(time_s);
    const GroundPose at = ground_pose(backend.pose(0), forward_rad);
    CHECK(at.x_m == doctest::Approx(radius_m * std::sin(rate_rad_s * time_s)).epsilon(1e-9));
    CHECK(at.y_m == doctest::Approx(-radius_m * (1.0 - std::cos(rate_rad_s * time_s))).epsilon(1e-9));
    CHECK(std::abs(wrap_angle(at.heading_rad + rate_rad_s * time_s)) < 1e-9);
  }
}

TEST_CASE("kinematic: left and right turns -> mirror images") {
  Kinematic backend = world({standing(0.0, 0.0, -forward_rad), standing(0.0, 0.0, -forward_rad)});
  backend.set_target_angle(0, 0.7);
  backend.set_target_angle(1, -0.7);
  backend.advance_to(30.0);
  const GroundPose right = ground_pose(backend.pose(0), forward_rad);
  const GroundPose left = ground_pose(backend.pose(1), forward_rad);
  CHECK(right.y_m < -0.1);
  CHECK(left.x_m == doctest::Approx(right.x_m).epsilon(1e-12));
  CHECK(left.y_m == doctest::Approx(-right.y_m).epsilon(1e-12));
}

TEST_CASE("kinematic: pace -> the same path that much faster or slower, standing at 0") {
  Kinematic plain = world({standing(0.0, 0.0, 0.0)});
  plain.set_target_angle(0, 0.7);
  plain.advance_to(13.0);
  for (const auto& [pace, time_s] : std::vector<std::pair<double, double>>{{1.3, 10.0}, {0.5, 26.0}, {1.0, 13.0}}) {
    Kinematic paced = world({standing(0.0, 0.0, 0.0)});
    paced.set_target_angle(0, 0.7);
    paced.set_pace(0, pace);
    paced.advance_to(time_s);
    CHECK((paced.pose(0).position_m - plain.pose(0).position_m).norm() < 1e-4);
    if (pace == 1.0) CHECK(paced.pose(0).position_m == plain.pose(0).position_m);
  }
  const Eigen::Vector3d before_m = plain.pose(0).position_m;
  plain.set_pace(0, 0.0);
  plain.advance_to(100.0);
  CHECK(plain.pose(0).position_m == before_m);
  CHECK(message_of<std::invalid_argument>([&] { plain.set_pace(0, -0.1); }) == "pace = -0.1: must be finite and >= 0");
}

TEST_CASE("kinematic: wall -> robot stops a radius away and slides along it") {
  Kinematic backend = world({standing(9.8, 0.0, 0.0)}, {.speed_scale = 2.0, .radius_m = 0.15});
  backend.advance_to(10.0);
  CHECK(backend.pose(0).position_m.x() == 9.85);
  CHECK(backend.pose(0).position_m.y() == doctest::Approx(0.1 * 10.0 / std::numbers::sqrt2));
}

TEST_CASE("kinematic: forward axis of the robot -> heading") {
  Kinematic gecko = world({standing(0.0, 0.0, 0.3)}, {}, slow, "gecko");
  gecko.advance_to(10.0);
  const Eigen::Vector3d at = gecko.pose(0).position_m;
  CHECK(std::atan2(at.y(), at.x()) == doctest::Approx(0.3));
}

TEST_CASE("kinematic: bad number -> error with field, value and bound") {
  const std::vector<Pose> one{standing(0.0, 0.0, 0.0)};
  CHECK(message_of<std::invalid_argument>([&] { world(one, {.speed_scale = -1.0}); }) ==
        "kinematic.speed_scale = -1: must be >= 0 and <= 100");
  CHECK(message_of<std::invalid_argument>([&] { world(one, {}, {}); }) ==
        "robot spider: walk.speed_m_s = 0: must be > 0 for a backend without joints; trophic measure-gait --walk measures it");
  CHECK(message_of<std::invalid_argument>([&] { world(one, {.timestep_s = 0.0}); }) ==
        "kinematic.timestep_s = 0: must be > 0 and <= 10");
  CHECK(message_of<std::invalid_argument>([&] { world(one, {.radius_m = 10.0}); }) ==
        "kinematic.radius_m = 10: must be < the arena's half side, 10");
  CHECK(message_of<std::invalid_argument>([&] { world({}); }) == "robots = 0: must be >= 1");
  CHECK(message_of<std::invalid_argument>([&] {
          world({standing(0.0, 0.0, 0.0), standing(0.0, -11.0, 0.0)});
        }) == "start pose 1 at (0, -11): must be finite and within +-10");
  CHECK(message_of<std::invalid_argument>([&] { world({standing(0.0, std::nan(""), 0.0)}); }) ==
        "start pose 0 at (0, nan): must be finite and within +-10");
  CHECK(message_of<std::invalid_argument>([&] { world({standing(0.0, 0.0, std::nan(""))}); }) ==
        "start pose 0: its heading must be finite");
  CHECK(message_of<std::invalid_argument>([&] {
          Kinematic backend = world(one);
          backend.set_target_angle(0, std::nan(""));
        }) == "target_angle_rad = nan: must be finite");
  CHECK(message_of<std::invalid_argument>([&] {
          Kinematic backend = world(one);
          backend.restore({});
        }) == "state.bodies.size() = 0: must be 1");
}

TEST_CASE("kinematic: robots of the rule tables -> walk of their files") {
  for (const char* name : {"spider", "spider_released"}) {
    const RobotModel robot = load_robot(name);
    Kinematic backend = world({standing(0.0, 0.0, -robot.forward_rad)}, {}, robot.walk, name);
    backend.set_target_angle(0, 0.7);
    backend.advance_to(0.1);
    const GroundPose at = ground_pose(backend.pose(0), robot.forward_rad);
    CHECK(std::abs(at.heading_rad / (-0.07 * robot.walk.turn_rate_per_rad) - 1.0) < 1e-9);
    CHECK(std::abs(at.x_m / (0.1 * robot.walk.speed_m_s) - 1.0) < 1e-4);
  }
}

TEST_CASE("kinematic: 6000 s of 30 steered robots -> same bits on every platform") {
  std::vector<Pose> starts;
  for (int i = 0; i < 30; ++i) starts.push_back(standing(0.6 * i - 9.0, 8.0 - 0.5 * i, 0.2 * i));
  Kinematic backend = world(starts);
  for (int tick = 0; tick < 3000; ++tick) {
    for (std::size_t robot = 0; robot < 30; ++robot) {
      backend.set_target_angle(robot, (static_cast<std::size_t>(tick) / 7 + robot) % 3 == 0 ? 0.7 : -0.7);
    }
    backend.advance_to(2.0 * (tick + 1));
  }
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a over the words
  for (const Kinematic::Body& body : backend.save().bodies) {
    for (const double value : {body.x_m, body.y_m, body.heading_rad})
      hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211ULL;
  }
  CHECK(hash == 13015780676203874133ULL);
}
