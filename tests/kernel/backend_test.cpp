// SPDX-License-Identifier: MIT
// The backend's fast stepping against one big MuJoCo model over 20 s.
#include <doctest/doctest.h>

#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/mujoco/agreement.hpp>
#include <trophic/backend/mujoco/islands.hpp>
#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using backend::Mujoco;
using backend::mujoco::BoxDepth;

namespace {

constexpr double tick_s = 1.0 / 60.0;

/// A core, and behind it two bricks on hinges of a trunk, each with a leg of two hinges on either side.
RobotModel six_legs() {
  body::Design design;
  design.name = "hexapod";
  std::size_t trunk = 0;
  std::vector<std::size_t> feet;
  for (int part = 0; part < 3; ++part) {
    for (const body::Face side : {body::Face::left, body::Face::right}) {
      const std::size_t hip = design.modules.attach(trunk, side, body::ModuleType::hinge, 1);
      feet.push_back(design.modules.attach(hip, body::Face::front, body::ModuleType::hinge, 0));
    }
    if (part == 2) break;
    const auto face = part == 0 ? body::Face::back : body::Face::front;
    const std::size_t hinge = design.modules.attach(trunk, face, body::ModuleType::hinge, 0);
    trunk = design.modules.attach(hinge, body::Face::front, body::ModuleType::brick, 0);
  }
  for (const std::size_t foot : feet) design.modules.attach(foot, body::Face::front, body::ModuleType::brick, 0);
  return body::build(design);
}

/// The same robot with links numbered by their distance from the root, unlike MuJoCo's.
RobotModel breadth_first(const RobotModel& robot) {
  std::vector<std::size_t> order{0};
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t link = 1; link < robot.links.size(); ++link) {
      if (robot.links[link].parent == static_cast<int>(order[i])) order.push_back(link);
    }
  }
  RobotModel result = robot;
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.links[i] = robot.links[order[i]];
    if (i == 0) continue;
    result.links[i].parent =
        static_cast<int>(std::ranges::find(order, static_cast<std::size_t>(robot.links[order[i]].parent)) - order.begin());
    result.hinges[i - 1] = robot.hinges[order[i] - 1];
    result.hinges[i - 1].servo.position_gain *= 1.0 + 0.05 * static_cast<double>(i);
  }
  return result;
}

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
void set_own_targets(Mujoco& world, double time_s) {
  for (std::size_t i = 0; i < world.robots(); ++i) {
    Rng rng{22, Stream::user, i};
    std::vector<double> targets_rad(world.joint_angles(i).size());
    for (double& target_rad : targets_rad) {
      const double amplitude_rad = rng.uniform(0.3, 1.1);
      const double rate_rad_s = rng.uniform(3.0, 9.0);
      target_rad = amplitude_rad * std::sin(rate_rad_s * time_s + rng.uniform(0.0, 6.0));
    }
    world.set_joint_targets(i, targets_rad);
  }
}

/// Walks for a time and returns the state.
Mujoco::State walk(Mujoco& world, double duration_s) {
  const int ticks = static_cast<int>(std::lround(duration_s / tick_s));
  for (int t = 0; t < ticks; ++t) {
    set_own_targets(world, t * tick_s);
    world.advance_to((t + 1) * tick_s);
  }
  return world.save();
}

/// Gives robots these bodies in turn, where they stand.
void embody(Mujoco& world, std::span<const RobotModel> bodies) {
  for (std::size_t i = 0; i < world.robots() && !bodies.empty(); ++i) {
    const RobotModel& body = bodies[i % bodies.size()];
    Pose pose = world.pose(i);
    pose.position_m.z() = body.rest_height_m;
    world.embody(i, body, pose);
  }
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
                    BoxDepth depth = BoxDepth::engine, std::span<const RobotModel> bodies = {}) {
  const RobotModel robot = load_robot(name);
  Arena arena;
  arena.half_side_m = half_side_m;
  arena.extent_m = 2 * half_side_m;
  const std::vector<Pose> starts = square(robot, robots, side_m);
  Mujoco fast{robot, arena, starts, Physics{}, {.stepping = Mujoco::Stepping::fast, .box_depth = depth}};
  Mujoco whole{robot, arena, starts, Physics{}, {.stepping = Mujoco::Stepping::one_model, .box_depth = depth}};
  embody(fast, bodies);
  embody(whole, bodies);
  walk(fast, duration_s);
  CHECK(fast.engine_share() < 0.02);
  walk(whole, duration_s);
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

TEST_CASE("kernel backend: crowd of several bodies -> the motion of one model") {
  const std::vector<RobotModel> bodies = {load_robot("gecko"), load_robot("spider"), six_legs()};
  // From 3.12 on two boxes of six legs meet at 5.9 s where rounding decides which contacts they have.
  const double duration_s = backend::mujoco::replaces_box_test ? 5.0 : 10.0;
  CHECK(disagreement("spider", 15, 2.2, duration_s, 10.0, BoxDepth::engine, bodies) < 1e-8);
}

TEST_CASE("kernel backend: six legs on a trunk, links numbered in any order -> stepped by the kernel") {
  const std::vector<RobotModel> bodies = {six_legs(), breadth_first(six_legs())};
  // At 2.3 s two boxes meet where contacts of MuJoCo 3.5 jump: one model moved by 1e-14 m differs from itself by 2 mm.
  const double duration_s = backend::mujoco::is_mujoco_3 ? 2.0 : 5.0;
  CHECK(disagreement("spider", 6, 6.0, duration_s, 10.0, BoxDepth::engine, bodies) < 1e-9);
}

TEST_CASE("kernel backend: check of a MuJoCo that was not tried -> passes, and finds other physics") {
  namespace engine = backend::mujoco;
  const double difference = engine::kernel_disagreement();
  MESSAGE("largest difference " << difference);
  CHECK_NOTHROW(engine::require_agreement(difference));
  const Physics euler{};
  const Physics heavier{.gravity_m_s2 = euler.gravity_m_s2 * (1.0 + 1e-6)};
  CHECK_THROWS_WITH(engine::require_agreement(engine::kernel_disagreement(euler, heavier)),
                    doctest::Contains("newer than all versions"));
  CHECK_THROWS(engine::require_agreement(engine::kernel_disagreement(euler, {.integrator = Integrator::rk4})));
}

TEST_CASE("kernel backend: bodies that change -> unused kinds and models dropped") {
  const RobotModel spider = load_robot("spider");
  Arena arena;
  backend::mujoco::Islands islands{
      spider, arena, {}, 1, BoxDepth::engine, std::make_unique<backend::mujoco::Lanes>(BoxDepth::engine, 1)};
  backend::mujoco::RobotStates states{islands.layout(), 3};
  for (std::size_t i = 0; i < 3; ++i)
    states.set_root(i, {{2.0 * static_cast<double>(i), 0.0, 1.0}, Eigen::Quaterniond::Identity()});
  backend::mujoco::Rows targets_rad{3, spider.hinges.size()};
  for (int change = 0; change < 5; ++change) {
    RobotModel body = spider;
    body.links[0].mass_kg += 0.01 * change;
    states.set_body(1, islands.set_body(1, body), backend::mujoco::layout_of(body, backend::mujoco::Servos::combined));
    states.set_root(1, {{2.0, 0.0, 1.0}, Eigen::Quaterniond::Identity()});
    backend::mujoco::RobotStates next = states;
    for (int i = 0; i < 300; ++i)
      REQUIRE(islands.advance(states, targets_rad, 1, next).end == backend::mujoco::GroupResult::End::done);
    CHECK(islands.kinds() <= 5);
  }
  backend::mujoco::RobotStates next = states;
  for (int i = 0; i < 1000; ++i) static_cast<void>(islands.advance(states, targets_rad, 1, next));
  CHECK(islands.kinds() == 2);
  CHECK(islands.models() <= 1);
}

namespace {

/// Walks 14 robots with several numbers of threads, and from a saved state.
void check_threads_and_restore(const std::string& name, const std::string& other_name, const Arena& arena, const Physics& physics,
                               BoxDepth depth = BoxDepth::engine) {
  const RobotModel robot = load_robot(name);
  const std::vector<Pose> starts = square(robot, 14, 2.5);
  Mujoco one{robot, arena, starts, physics, {.threads = 1, .box_depth = depth}};
  const std::vector<RobotModel> bodies = {robot, load_robot(other_name)};
  embody(one, bodies);
  const Mujoco::State expected = walk(one, 2.0);
  for (const std::size_t threads : {2U, 4U}) {
    Mujoco several{robot, arena, starts, physics, {.threads = threads, .box_depth = depth}};
    embody(several, bodies);
    CHECK(walk(several, 2.0) == expected);
  }
  Mujoco other{robot, arena, starts, physics, {.threads = 2, .box_depth = depth}};
  if (bodies[1].hinges.size() != robot.hinges.size()) CHECK_THROWS_AS(other.restore(expected), std::invalid_argument);
  embody(other, bodies);
  other.restore(expected);
  set_own_targets(other, 2.0);
  set_own_targets(one, 2.0);
  other.advance_to(2.5);
  one.advance_to(2.5);
  CHECK(other.save() == one.save());
}

}  // namespace

TEST_CASE("kernel backend: another number of threads, or a restored state -> the same bits") {
  check_threads_and_restore("spider", "gecko", {}, {});
  check_threads_and_restore("spider", "gecko", {}, {}, BoxDepth::whole);
  check_threads_and_restore("spider_released", "spider", load_arena("height_field"),
                            {.timestep_s = 0.012, .integrator = Integrator::rk4});
}

TEST_CASE("kernel backend: more robots in one heap than the kernel steps -> MuJoCo steps them, and a remark") {
  const RobotModel robot = load_robot("spider");
  const Arena arena{.name = "square", .half_side_m = 5.0, .extent_m = 10.0, .height_field = {}};
  const auto remark = [&](std::size_t robots, double side_m, Mujoco::Stepping stepping, bool asked = false) {
    Mujoco world{robot, arena, square(robot, robots, side_m), Physics{}, {.stepping = stepping}};
    CHECK(world.speed_remark().empty());
    world.advance_to(0.012);
    return world.speed_remark(asked);
  };
  CHECK(remark(40, 1.8, Mujoco::Stepping::fast).starts_with("backend.stepping = fast: MuJoCo itself computed "));
  CHECK(remark(40, 1.8, Mujoco::Stepping::islands).empty());
  CHECK(remark(4, 4.0, Mujoco::Stepping::islands, true) == "backend.stepping = islands does not count steps");
  CHECK(remark(4, 4.0, Mujoco::Stepping::fast).empty());
}
