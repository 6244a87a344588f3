// SPDX-License-Identifier: MIT
// The backend's fast stepping against one big MuJoCo model over 20 s.
#include <doctest/doctest.h>

#include <cmath>
#include <trophic/backend/mujoco.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using backend::Mujoco;
using backend::mujoco::BoxDepth;

namespace {

constexpr double tick_s = 1.0 / 60.0;

/// Robots that stand in a square of the given side, facing anywhere.
std::vector<Pose> square(const RobotModel& robot, std::size_t robots, double side_m) {
  Rng rng{21, Stream::user};
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(robots))));
  const double spacing_m = side_m / static_cast<double>(columns);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < robots; ++i) {
    const double x_m = (static_cast<double>(i % columns) + 0.5) * spacing_m - side_m / 2;
    const double y_m = (static_cast<double>(i / columns) + 0.5) * spacing_m - side_m / 2;
    Pose& pose = poses.emplace_back();
    pose.position_m = {x_m, y_m, robot.rest_height_m};
    pose.orientation = Eigen::AngleAxisd(rng.uniform(-3.0, 3.0), Eigen::Vector3d::UnitZ());
  }
  return poses;
}

/// Each robot's own gait.
void set_own_targets(Mujoco& world, std::size_t hinges, double time_s) {
  std::vector<double> targets_rad(hinges);
  for (std::size_t i = 0; i < world.robots(); ++i) {
    Rng rng{22, Stream::user, i};
    for (double& target_rad : targets_rad) {
      const double amplitude_rad = rng.uniform(0.3, 1.1);
      const double rate_rad_s = rng.uniform(3.0, 9.0);
      target_rad = amplitude_rad * std::sin(rate_rad_s * time_s + rng.uniform(0.0, 6.0));
    }
    world.set_joint_targets(i, targets_rad);
  }
}

/// Walks for a time and returns the state.
Mujoco::State walk(Mujoco& world, std::size_t hinges, double duration_s) {
  const int ticks = static_cast<int>(std::lround(duration_s / tick_s));
  for (int t = 0; t < ticks; ++t) {
    set_own_targets(world, hinges, t * tick_s);
    world.advance_to((t + 1) * tick_s);
  }
  return world.save();
}

double largest_difference(const Mujoco& a, const Mujoco& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.robots(); ++i) {
    largest = std::max(largest, (a.pose(i).position_m - b.pose(i).position_m).cwiseAbs().maxCoeff());
    largest = std::max(largest, (a.pose(i).orientation.coeffs() - b.pose(i).orientation.coeffs()).cwiseAbs().maxCoeff());
    for (std::size_t j = 0; j < a.joint_angles(i).size(); ++j) {
      largest = std::max(largest, std::abs(a.joint_angles(i)[j] - b.joint_angles(i)[j]));
    }
  }
  return largest;
}

/// Largest difference of any coordinate after a walk, between fast stepping and one model.
double disagreement(const std::string& name, std::size_t robots, double side_m, double duration_s, double half_side_m = 10.0,
                    BoxDepth depth = BoxDepth::engine) {
  const RobotModel robot = load_robot(name);
  Arena arena;
  arena.half_side_m = half_side_m;
  arena.extent_m = 2 * half_side_m;
  const std::vector<Pose> starts = square(robot, robots, side_m);
  Mujoco fast{robot, arena, starts, Physics{}, {.stepping = Mujoco::Stepping::fast, .box_depth = depth}};
  Mujoco whole{robot, arena, starts, Physics{}, {.stepping = Mujoco::Stepping::one_model, .box_depth = depth}};
  walk(fast, robot.hinges.size(), duration_s);
  walk(whole, robot.hinges.size(), duration_s);
  const double difference = largest_difference(fast, whole);
  MESSAGE(robots << " of " << name << " in " << side_m << " m, " << duration_s << " s: " << difference);
  return difference;
}

}  // namespace

TEST_CASE("kernel backend: 30 spread robots, 20 s -> the motion of one model") {
  CHECK(disagreement("spider", 30, 18.0, 20.0) < 1e-9);
}

TEST_CASE("kernel backend: crowd that touches, 20 s -> the motion of one model") {
  CHECK(disagreement("spider", 16, 1.8, 20.0) < 1e-8);
}

TEST_CASE("kernel backend: crowd with the whole depth between boxes -> the motion of one model") {
  CHECK(disagreement("spider", 16, 1.8, 10.0, 10.0, BoxDepth::whole) < 1e-8);
}

TEST_CASE("kernel backend: robots that run into walls -> the motion of one model") {
  CHECK(disagreement("spider", 4, 1.3, 10.0, 0.75) < 1e-8);
}

TEST_CASE("kernel backend: geckos, whose legs touch often -> the motion of one model") {
  CHECK(disagreement("gecko", 4, 6.0, 10.0) < 1e-9);
}

namespace {

/// Walks 14 robots with several numbers of threads, and from a saved state.
void check_threads_and_restore(const std::string& name, const Arena& arena, const Physics& physics,
                               BoxDepth depth = BoxDepth::engine) {
  const RobotModel robot = load_robot(name);
  const std::vector<Pose> starts = square(robot, 14, 2.5);
  Mujoco one{robot, arena, starts, physics, {.threads = 1, .box_depth = depth}};
  const Mujoco::State expected = walk(one, robot.hinges.size(), 2.0);
  for (const std::size_t threads : {2U, 4U}) {
    Mujoco several{robot, arena, starts, physics, {.threads = threads, .box_depth = depth}};
    CHECK(walk(several, robot.hinges.size(), 2.0) == expected);
  }
  Mujoco other{robot, arena, starts, physics, {.threads = 2, .box_depth = depth}};
  other.restore(expected);
  set_own_targets(other, robot.hinges.size(), 2.0);
  set_own_targets(one, robot.hinges.size(), 2.0);
  other.advance_to(2.5);
  one.advance_to(2.5);
  CHECK(other.save() == one.save());
}

}  // namespace

TEST_CASE("kernel backend: another number of threads, or a restored state -> the same bits") {
  check_threads_and_restore("spider", {}, {});
  check_threads_and_restore("spider", {}, {}, BoxDepth::whole);
  check_threads_and_restore("spider_released", load_arena("height_field"), {.timestep_s = 0.012, .integrator = Integrator::rk4});
}
