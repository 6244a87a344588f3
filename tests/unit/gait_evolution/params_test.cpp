// SPDX-License-Identifier: MIT
// Selection, fitness and the trials that they judge.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <support/temporary_folder.hpp>
#include <support/toy_backend.hpp>
#include <tools/gait_evolution/params.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>

namespace gait_evolution = trophic::gait_evolution;
using doctest::Approx;
using gait_evolution::Pilot;
using gait_evolution::Selection;
using gait_evolution::SelectionRule;
using gait_evolution::Track;
using trophic::GroundPose;
using trophic::test::message_of;
using Indices = std::vector<std::size_t>;

namespace {

constexpr double pi = std::numbers::pi;
const std::vector<double> four{1.0, 4.0, 2.0, 3.0};

trophic::Rng rng(std::uint64_t event = 0) {
  return {5, trophic::Stream::gait_selection, 0, event};
}

std::string refusal(const Selection& selection, const std::vector<double>& fitness, std::size_t count) {
  auto random = rng();
  return message_of<std::invalid_argument>([&] { static_cast<void>(selection.select(fitness, count, random)); });
}

/// A perfect walker: moves along its heading at that speed; the target angle turns it to the right at that rate, rad/s. 10 steps
/// a second.
Track perfect_walk(const Pilot& pilot, double start_turn_rad, double duration_s, double speed_m_s) {
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

/// Its engine takes most steps.
struct DecliningToy : trophic::test::ToyBackend {
  struct Params : trophic::test::ToyBackend::Params {
    using Backend = DecliningToy;
  };
  using ToyBackend::ToyBackend;
  [[nodiscard]] static double engine_share() { return 0.75; }
};

}  // namespace

TEST_CASE("round robin: against all -> most wins first, equals by age") {
  auto random = rng();
  const std::vector<double> fitness{3.0, 1.0, 2.0, 5.0, 3.0, -std::numeric_limits<double>::infinity()};
  const Selection round_robin;
  CHECK(round_robin.select(fitness, 3, random) == Indices{3, 0, 4});
  CHECK(round_robin.select(fitness, 6, random) == Indices{3, 0, 4, 2, 1, 5});
  CHECK(refusal(round_robin, fitness, 7) == "round_robin: 7 distinct individuals wanted: must be <= 6");
}

TEST_CASE("round robin: one opponent -> the best always wins, the second best in two of three meetings") {
  int third_before_second = 0;
  constexpr int rounds = 3000;
  for (int i = 0; i < rounds; ++i) {
    auto random = rng(static_cast<std::uint64_t>(i));
    const Indices order = Selection{.opponents = 1}.select(four, 4, random);
    CHECK(order.front() == 1);
    third_before_second += std::ranges::find(order, 2) < std::ranges::find(order, 3) ? 1 : 0;
  }
  // The third passes the second where it wins (1 of 3) and the second loses (1 of 3).
  CHECK(third_before_second / static_cast<double>(rounds) == Approx(1.0 / 9.0).epsilon(0.15));
}

TEST_CASE("tournament couples: tournaments of 2 -> each rank with its probability, and never one individual as both parents") {
  const Selection couples{.rule = SelectionRule::tournament_couples};
  auto random = rng();
  constexpr std::size_t count = 40000;
  const Indices selected = couples.select(four, 2 * count, random);
  REQUIRE(selected.size() == 2 * count);
  const std::array<double, 4> wins{1.0 / 16.0, 7.0 / 16.0, 3.0 / 16.0, 5.0 / 16.0};
  std::array<std::array<double, 4>, 4> share{};  // of couples, by first and second parent
  for (std::size_t i = 0; i < 2 * count; i += 2) share.at(selected[i]).at(selected[i + 1]) += 1.0 / count;
  for (std::size_t first = 0; first < 4; ++first) {
    CHECK(share[first][first] == 0.0);
    for (std::size_t second = 0; second < 4; ++second) {
      if (second == first) continue;
      const double expected = wins[first] * wins[second] / (1.0 - wins[first]);
      CHECK(std::abs(share[first][second] - expected) < 4.0 * std::sqrt(expected / count));
    }
  }
  CHECK(refusal(couples, {1.0}, 2) == "tournament_couples: 1 individuals: must be >= 2");
  CHECK(refusal(couples, four, 3) == "tournament_couples: 3 parents: must be even");
}

TEST_CASE("tournament: any draw -> no individual is selected twice") {
  const Selection tournament{.rule = SelectionRule::tournament};
  auto random = rng();
  Indices all = tournament.select(four, 4, random);
  std::ranges::sort(all);
  CHECK(all == Indices{0, 1, 2, 3});
  CHECK(refusal(tournament, four, 5) == "tournament: 5 distinct individuals wanted: must be <= 4");
}

TEST_CASE("track: turning rate and speeds of a walk on a circle that swings its body") {
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

TEST_CASE("fitness: displacement along -x, unsteered and steered") {
  std::vector<double> asked;
  const gait_evolution::TryOut drifts = [&](const Pilot& pilot, double start_turn_rad) {
    CHECK(start_turn_rad == 0.0);
    asked.push_back(pilot(0.0, {0.0, 0.0, pi - 0.25}));
    return Track{.control_hz = 1.0, .poses = {{1.0, 0.0, pi}, {-0.5, 4.0, 2.0}}};
  };
  CHECK(gait_evolution::Fitness{}.score(drifts) == 1.5);
  CHECK(gait_evolution::Fitness{.aim = gait_evolution::Aim::minus_x}.score(drifts) == 1.5);
  CHECK(asked[0] == 0.0);
  CHECK(asked[1] == Approx(-0.25));
}

TEST_CASE("steered displacement: the pilot decides every 2 s, and only a walker that turns to both sides gets far") {
  const gait_evolution::Fitness steered{.rule = gait_evolution::FitnessRule::steered_displacement};
  const gait_evolution::TryOut look = [&](const Pilot& pilot, double) {
    CHECK(pilot(0.0, {0.0, 0.0, pi - 0.1}) == -0.7);
    CHECK(pilot(1.9, {0.0, 0.0, -pi + 0.1}) == -0.7);
    CHECK(pilot(2.0, {0.0, 0.0, -pi + 0.1}) == 0.7);
    CHECK(pilot(3.9, {0.0, 0.0, pi - 0.1}) == 0.7);
    CHECK(pilot(4.0, {0.0, 0.0, pi - 0.1}) == -0.7);
    return Track{.control_hz = 1.0, .poses = {{}}};
  };
  CHECK(steered.score(look) == 0.0);

  const auto score = [&](double left, double right, double speed_m_s = 1.0) {
    return steered.score([&](const Pilot& pilot, double start_turn_rad) {
      const Pilot felt = [&](double time_s, const GroundPose& now) {
        const double angle = pilot(time_s, now);
        return angle * (angle < 0.0 ? left : right);
      };
      return perfect_walk(felt, start_turn_rad, 50.0, speed_m_s);
    });
  };
  CHECK(score(1.0, 1.0) > 30.0);
  CHECK(score(0.3, 0.3) > 20.0);
  CHECK(score(1.0, 0.0) < 15.0);
  CHECK(std::abs(score(0.0, 0.0)) < 1e-9);
  CHECK(score(-1.0, -1.0) <= 0.0);
  // Backwards, turned the wrong way: it reaches its aim without facing it.
  CHECK(score(-1.0, -1.0, -1.0) < 1.0);
}

TEST_CASE("trial: facing -> its start pose, and the pilot is asked at the control rate") {
  const trophic::RobotModel robot = trophic::load_robot("spider");
  const trophic::Gait gait = trophic::load_gait("spider_published");
  gait_evolution::Trial trial{.duration_s = 2.0, .control_hz = 10.0, .idle_steps = 3};
  std::vector<double> times_s;
  const auto run = [&](double start_turn_rad, const trophic::BackendChoice& backend) {
    times_s.clear();
    return gait_evolution::try_out(
        robot, gait, {}, trial, {}, backend,
        [&](double time_s, const GroundPose&) {
          times_s.push_back(time_s);
          return 0.0;
        },
        start_turn_rad);
  };
  const trophic::test::ToyBackend::Params toy;
  const Track track = run(0.0, toy);
  CHECK(track.engine_share == 0.0);
  CHECK(track.poses.size() == 21);
  CHECK(std::abs(trophic::wrap_angle(track.poses[0].heading_rad - pi)) < 1e-12);
  CHECK(track.poses[3].x_m == 0.0);  // idle
  CHECK(track.poses[4].x_m != 0.0);
  REQUIRE(times_s.size() == 17);
  CHECK(times_s[0] == Approx(0.3));
  CHECK(times_s[16] == Approx(1.9));
  CHECK(run(0.5, toy).poses[0].heading_rad == Approx(0.5 - pi));
  trial.facing = gait_evolution::Facing::core_x;
  CHECK(run(0.0, toy).poses[0].heading_rad == Approx(robot.forward_rad - pi));
  CHECK(run(0.0, DecliningToy::Params{}).engine_share == 0.75);
}
