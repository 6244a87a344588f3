// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <support/toy_backend.hpp>
#include <tools/gait_evolution/fitness.hpp>
#include <tools/gait_evolution/trial.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

namespace gait_evolution = trophic::gait_evolution;
using doctest::Approx;
using gait_evolution::Pilot;
using gait_evolution::Track;
using trophic::GroundPose;

namespace {

constexpr double pi = std::numbers::pi;

/// A perfect walker: moves along its heading at that speed; the target angle turns it to the right at that rate, rad/s. 10 steps
/// a second.
Track perfect_walk(const Pilot& pilot, double start_turn_rad, double duration_s, double speed_m_s = 1.0) {
  Track track{.control_hz = 10.0, .poses = {{0.0, 0.0, trophic::wrap_angle(pi + start_turn_rad)}}};
  for (int step = 0; step < static_cast<int>(duration_s * 10.0); ++step) {
    GroundPose now = track.poses.back();
    now.heading_rad = trophic::wrap_angle(now.heading_rad - 0.1 * pilot(0.1 * step, now));
    now.x_m += 0.1 * speed_m_s * std::cos(now.heading_rad);
    now.y_m += 0.1 * speed_m_s * std::sin(now.heading_rad);
    track.poses.push_back(now);
  }
  return track;
}

}  // namespace

TEST_CASE("a track's measures by hand") {
  const Track track{.control_hz = 2.0, .poses = {{1.0, 2.0, 3.0}, {0.0, 2.0, -3.0}, {-2.0, -2.0, 2.5}, {-2.0, -2.0, 3.0}}};
  CHECK(track.duration_s() == 1.5);
  CHECK(track.displacement_minus_x_m() == 3.0);
  CHECK(track.displacement_m() == 5.0);
  CHECK(track.turned_rad()[1] == Approx(2 * pi - 6.0));
  CHECK(track.turned_rad()[3] == Approx(0.0));
  CHECK(gait_evolution::bearing_of_minus_x_rad({0.0, 0.0, pi / 2.0}) == Approx(-pi / 2.0));
  CHECK(gait_evolution::bearing_of_minus_x_rad({0.0, 0.0, -pi / 2.0}) == Approx(pi / 2.0));
}

TEST_CASE("turning rate and speeds of a walk on a circle that swings its body") {
  Track track{.control_hz = 60.0, .poses = {}};
  constexpr double rate = 0.2;   // rad/s, to the left
  constexpr double speed = 0.1;  // m/s along the circle
  for (int i = 0; i <= 3600; ++i) {
    const double t = i / 60.0;
    const double swing = 0.3 * std::sin(2.0 * pi * t);
    track.poses.push_back({speed / rate * std::sin(rate * t), speed / rate * (1.0 - std::cos(rate * t)),
                           trophic::wrap_angle(rate * t + swing - 0.5)});
  }
  CHECK(std::abs(track.turn_rate_rad_s() - rate) < 1e-3);
  // The body points 0.5 rad to the right of its direction of motion; a chord of 1 rad is shorter than its arc by sin(0.5) / 0.5.
  const double chord = speed * std::sin(0.5) / 0.5;
  const auto [forward, left] = track.forward_and_left_m_s(5.0);
  CHECK(std::abs(forward - chord * std::cos(0.5)) < 1e-3);
  CHECK(std::abs(left - chord * std::sin(0.5)) < 1e-3);
}

TEST_CASE("displacement along -x, unsteered and steered") {
  std::vector<double> asked;
  const gait_evolution::TryOut drifts = [&](const Pilot& pilot, double start_turn_rad) {
    CHECK(start_turn_rad == 0.0);
    asked.push_back(pilot(0.0, {0.0, 0.0, pi - 0.25}));
    return Track{.control_hz = 1.0, .poses = {{1.0, 0.0, pi}, {-0.5, 4.0, 2.0}}};
  };
  CHECK(gait_evolution::DisplacementMinusX{}.fitness(drifts) == 1.5);
  CHECK(gait_evolution::DisplacementMinusX{{.aim = gait_evolution::Aim::minus_x}}.fitness(drifts) == 1.5);
  CHECK(asked[0] == 0.0);
  CHECK(asked[1] == Approx(-0.25));
}

TEST_CASE("steered displacement: the pilot decides every 2 s, by the side that -x is on") {
  const gait_evolution::TryOut look = [&](const Pilot& pilot, double) {
    CHECK(pilot(0.0, {0.0, 0.0, pi - 0.1}) == -0.7);
    CHECK(pilot(1.9, {0.0, 0.0, -pi + 0.1}) == -0.7);
    CHECK(pilot(2.0, {0.0, 0.0, -pi + 0.1}) == 0.7);
    CHECK(pilot(3.9, {0.0, 0.0, pi - 0.1}) == 0.7);
    CHECK(pilot(4.0, {0.0, 0.0, pi - 0.1}) == -0.7);
    return Track{.control_hz = 1.0, .poses = {{}}};
  };
  CHECK(gait_evolution::SteeredDisplacement{}.fitness(look) == 0.0);
}

TEST_CASE("steered displacement: only a walker that turns to both sides gets far") {
  const gait_evolution::SteeredDisplacement steered;
  const auto walker = [](double left, double right, double speed_m_s = 1.0) {
    return [=](const Pilot& pilot, double start_turn_rad) {
      const Pilot felt = [&](double time_s, const GroundPose& now) {
        const double angle = pilot(time_s, now);
        return angle * (angle < 0.0 ? left : right);
      };
      return perfect_walk(felt, start_turn_rad, 50.0, speed_m_s);
    };
  };
  CHECK(steered.fitness(walker(1.0, 1.0)) > 30.0);
  CHECK(steered.fitness(walker(0.3, 0.3)) > 20.0);
  CHECK(steered.fitness(walker(1.0, 0.0)) < 15.0);
  CHECK(std::abs(steered.fitness(walker(0.0, 0.0))) < 1e-9);
  CHECK(steered.fitness(walker(-1.0, -1.0)) <= 0.0);
  // Backwards, turned the wrong way: it reaches its aim without facing it.
  CHECK(steered.fitness(walker(-1.0, -1.0, -1.0)) < 1.0);
}

namespace {

/// Its engine takes most steps.
struct DecliningToy : trophic::test::ToyBackend {
  struct Params : trophic::test::ToyBackend::Params {
    using Backend = DecliningToy;
  };
  using ToyBackend::ToyBackend;
  [[nodiscard]] static double engine_share() { return 0.75; }
};

}  // namespace

TEST_CASE("trial: facing -> its start pose, and the pilot is asked at the control rate") {
  const trophic::RobotModel robot = trophic::load_robot("spider");
  const trophic::Gait gait = trophic::load_gait("spider_published");
  gait_evolution::Trial trial{.duration_s = 2.0, .control_hz = 10.0, .idle_steps = 3};
  std::vector<double> times_s;
  const auto run = [&](double start_turn_rad) {
    times_s.clear();
    return gait_evolution::try_out(
        robot, gait, trophic::control::steering::TargetedSteering{}, trial, {}, trophic::test::ToyBackend::Params{},
        [&](double time_s, const GroundPose&) {
          times_s.push_back(time_s);
          return 0.0;
        },
        start_turn_rad);
  };
  const Track track = run(0.0);
  CHECK(track.poses.size() == 21);
  CHECK(std::abs(trophic::wrap_angle(track.poses[0].heading_rad - pi)) < 1e-12);
  CHECK(track.poses[3].x_m == 0.0);  // idle
  CHECK(track.poses[4].x_m != 0.0);
  REQUIRE(times_s.size() == 17);
  CHECK(times_s[0] == Approx(0.3));
  CHECK(times_s[16] == Approx(1.9));
  CHECK(run(0.5).poses[0].heading_rad == Approx(0.5 - pi));
  trial.facing = gait_evolution::Facing::core_x;
  CHECK(run(0.0).poses[0].heading_rad == Approx(robot.forward_rad - pi));
}

TEST_CASE("trial: backend with a share of steps that its engine took -> the track has it") {
  const trophic::RobotModel robot = trophic::load_robot("spider");
  const trophic::Gait gait = trophic::load_gait("spider_published");
  const trophic::control::steering::TargetedSteering steering;
  const gait_evolution::Trial trial{.duration_s = 1.0};
  const auto straight = gait_evolution::steady(0.0);
  CHECK(gait_evolution::try_out(robot, gait, steering, trial, {}, DecliningToy::Params{}, straight).engine_share == 0.75);
  CHECK(gait_evolution::try_out(robot, gait, steering, trial, {}, trophic::test::ToyBackend::Params{}, straight).engine_share ==
        0.0);
}
