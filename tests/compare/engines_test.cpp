// SPDX-License-Identifier: MIT
// The same scenes in MuJoCo and ODE: quantities that both must get right. If they differ, the reason is next to the
// tolerance.
#include <doctest/doctest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare/scenes.hpp>
#include <cstddef>
#include <numbers>
#include <soak/resting.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::compare;
using trophic::backend::Mujoco;
using trophic::backend::Ode;

namespace {

/// Semi-implicit Euler falls g h t / 2 farther than the parabola, in both engines alike.
constexpr double free_fall_m = 1e-9;
/// Both sink into the floor until their springs carry the weight. MuJoCo's are as stiff as the touching link is heavy, ODE's are
/// equal everywhere: a tenth of a millimetre each.
constexpr double resting_height_m = 0.0003;
/// Small differences of the angles turn and shift the root.
constexpr double swinging_m = 0.001;
constexpr double weight_share = 0.01;
/// The tower stands on soft ground and gives way a little.
constexpr double period_share = 0.005;
/// Against the exact solution. MuJoCo takes the servo's damping from the step's start, ODE from its end: at 0.2 ms the overshoot
/// of the one is a little above, of the other a little below.
constexpr double step_response_rad = 0.006;
/// ODE keeps each link's momentum; the visible error are its hinges, which come apart by micrometres under load. MuJoCo
/// integrates in joint coordinates, which keeps momentum only to first order in the timestep: half the step, half the drift.
constexpr double ode_drift_m = 5e-6;
constexpr double mujoco_drift_m_per_s_step = 60.0;
constexpr double sliding_share = 0.05;
/// A loaded contact that does not slide creeps: both engines' friction is a damper below the limit.
constexpr double creep_m_s = 0.005;
/// ODE's robots tremble at rest, their roots by hundredths of a millimetre, and creep: a spider by 0.3 mm in a second.
constexpr double ode_trembling_J = 1e-3;
constexpr double ode_creep_m_s = 0.0006;
/// Soft stops, as stiff as the arm is inert in MuJoCo, of the spider's stiffness in ODE.
constexpr double limit_rad = 0.01;

Physics with_step(double timestep_s, double gravity_m_s2 = 9.81) {
  return {.timestep_s = timestep_s, .gravity_m_s2 = gravity_m_s2};
}

std::vector<Pose> one_at(double z_m) {
  return {{.position_m = {0.0, 0.0, z_m}}};
}

template <class B>
double fallen_m() {
  const RobotModel robot = load_robot("spider");
  B backend{robot, load_arena("walled_square"), one_at(2.0), Physics{}, {}};
  backend.advance_to(0.5);
  return 2.0 - backend.pose(0).position_m.z();
}

template <class B>
double resting_m() {
  const RobotModel robot = load_robot("spider");
  B backend{robot, load_arena("walled_square"), one_at(robot.rest_height_m), Physics{}, {}};
  backend.advance_to(2.0);
  return backend.pose(0).position_m.z();
}

/// Heights at which a spider and a gecko rest, of which the second took a spider's place.
template <class B>
std::array<double, 2> resting_pair_m() {
  const RobotModel spider = load_robot("spider");
  const RobotModel gecko = load_robot("gecko");
  const std::vector<Pose> starts{{.position_m = {0.0, 0.0, spider.rest_height_m}}, {.position_m = {1.0, 0.0, 2.0}}};
  B backend{spider, load_arena("walled_square"), starts, Physics{}, {}};
  backend.embody(1, gecko, {.position_m = {1.0, 0.0, gecko.rest_height_m}});
  backend.advance_to(2.0);
  return {backend.pose(0).position_m.z() - spider.rest_height_m, backend.pose(1).position_m.z() - gecko.rest_height_m};
}

/// A spider and a gecko, which took a spider's place, move their hinges to one side and the other in the air.
template <class B>
B swinging_pair() {
  const RobotModel spider = load_robot("spider");
  const RobotModel gecko = load_robot("gecko");
  const std::vector<Pose> starts{{.position_m = {0.0, 0.0, 2.0}}, {.position_m = {2.0, 0.0, 2.0}}};
  B backend{spider, load_arena("walled_square"), starts, with_step(0.0002, 0.0), {}};
  backend.embody(1, gecko, starts[1]);
  for (const std::size_t robot : {0U, 1U}) {
    std::vector<double> targets_rad(backend.joint_angles(robot).size());
    for (std::size_t i = 0; i < targets_rad.size(); ++i) targets_rad[i] = i % 2 == 0 ? 0.5 : -0.4;
    backend.set_joint_targets(robot, targets_rad);
  }
  return backend;
}

/// Energy gained and distance moved by standing spiders in a minute, after one to come to rest.
template <class B>
test::Resting after_a_minute_at_rest(test::Resting resting) {
  const RobotModel robot = load_robot("spider");
  std::vector<Pose> poses(3, {.position_m = {0.0, 0.0, robot.rest_height_m}});
  for (std::size_t body = 0; body < poses.size(); ++body) poses[body].position_m.x() = 1.5 * static_cast<double>(body);
  B backend{robot, load_arena("walled_square"), poses, Physics{}, {}};
  for (double time_s = 1.0; time_s <= 2.0 * test::Resting::settles_s; time_s += 1.0) {
    backend.advance_to(time_s);
    for (std::size_t body = 0; body < poses.size(); ++body) poses[body] = backend.pose(body);
    resting.see(time_s, poses, robot);
  }
  return resting;
}

/// Time between every second passage of the lowest point.
template <class B>
double period_s() {
  const Pendulum pendulum;
  const RobotModel robot = pendulum.robot();
  const double timestep_s = 0.0005;
  B backend{robot, load_arena("walled_square"), one_at(robot.rest_height_m), with_step(timestep_s), {}};
  std::vector<double> passages_s;
  double before_rad = pendulum.start_rad;
  watch(backend, 3.0, timestep_s, [&](double time_s) {
    const double from_down_rad = backend.joint_angles(0)[0] + pendulum.start_rad;
    if (from_down_rad * before_rad < 0.0) {
      passages_s.push_back(time_s - timestep_s * from_down_rad / (from_down_rad - before_rad));
    }
    before_rad = from_down_rad;
  });
  const std::size_t periods = (passages_s.size() - 1) / 2;
  REQUIRE(periods >= 3);
  return (passages_s[2 * periods] - passages_s[0]) / static_cast<double>(periods);
}

/// Angles of a servo step to 0.5 rad at 5, 10, 20, 40 ms.
template <class B>
std::array<double, 4> step_response_rad_at(std::span<const double, 4> times_s, const Pendulum& pendulum, double timestep_s) {
  const RobotModel robot = pendulum.robot();
  B backend{robot, load_arena("walled_square"), one_at(1.0), with_step(timestep_s, 0.0), {}};
  const std::array<double, 1> target_rad{0.5};
  backend.set_joint_targets(0, target_rad);
  std::array<double, 4> angles_rad{};
  for (std::size_t i = 0; i < 4; ++i) {
    backend.advance_to(times_s[i]);
    angles_rad[i] = backend.joint_angles(0)[0];
  }
  return angles_rad;
}

/// I q'' = kp (target - q) - kv q' from rest at 0.
double exact_response_rad(double time_s, const Servo& servo, double inertia_kgm2, double target_rad) {
  const double decay = servo.velocity_gain / (2.0 * inertia_kgm2);
  const double omega = std::sqrt(servo.position_gain / inertia_kgm2 - decay * decay);
  return target_rad * (1.0 - std::exp(-decay * time_s) * (std::cos(omega * time_s) + decay / omega * std::sin(omega * time_s)));
}

struct Collision {
  double drift_m = 0.0;       ///< of both robots' common centre of mass
  double separation_m = 0.0;  ///< how far each robot's own went
};

/// Two robots without weight kick each other.
template <class B>
Collision collide(double timestep_s) {
  const RobotModel robot = load_robot("spider");
  const std::vector<Pose> starts{{.position_m = {0.0, 0.0, 2.0}}, {.position_m = {0.25, 0.05, 2.08}}};
  B backend{robot, load_arena("walled_square"), starts, with_step(timestep_s, 0.0), {}};
  const auto common_m = [&]() -> Eigen::Vector3d {
    return 0.5 * (centre_of_mass_m(backend, robot, 0) + centre_of_mass_m(backend, robot, 1));
  };
  const Eigen::Vector3d start_m = common_m();
  const Eigen::Vector3d own_start_m = centre_of_mass_m(backend, robot, 0);
  for (int i = 0; i < 60; ++i) {
    const double swing_rad = i % 20 < 10 ? 1.0 : -1.0;
    backend.set_joint_targets(0, std::array{swing_rad, swing_rad, -swing_rad, swing_rad});
    backend.set_joint_targets(1, std::array{-swing_rad, swing_rad, swing_rad, swing_rad});
    backend.advance_to((i + 1) / 60.0);
  }
  return {.drift_m = (common_m() - start_m).norm(), .separation_m = (centre_of_mass_m(backend, robot, 0) - own_start_m).norm()};
}

/// A flat brick on a plane tilted by `slope_rad` along `direction`, and how far it slid down in `duration_s`.
template <class B>
double slid_m(double slope_rad, const Eigen::Vector2d& direction, double friction, double duration_s) {
  const RobotModel robot = brick({0.3, 0.3, 0.1}, 0.5, friction);
  const Arena arena = tilted_plane(std::tan(slope_rad), direction, friction);
  const Eigen::Vector3d uphill{direction.x(), direction.y(), std::tan(slope_rad)};
  const Eigen::Quaterniond tilt = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d{direction.x(), direction.y(), 0.0}, uphill);
  const Eigen::Vector3d normal = tilt * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d foot{0.0, 0.0, height_at_origin_m(arena)};
  const std::vector<Pose> starts{{.position_m = foot + robot.rest_height_m * normal, .orientation = tilt}};
  B backend{robot, arena, starts, Physics{}, {}};
  backend.advance_to(duration_s);
  return -(backend.pose(0).position_m - starts[0].position_m).dot(uphill.normalized());
}

template <class B>
double rest_angle_at_limit_rad() {
  const Pendulum pendulum{.range_rad = 0.4};
  const RobotModel robot = pendulum.robot();
  B backend{robot, load_arena("walled_square"), one_at(robot.rest_height_m), Physics{}, {}};
  backend.advance_to(2.0);
  return backend.joint_angles(0)[0];
}

double agm(double a, double b) {
  for (int i = 0; i < 10; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}

}  // namespace

TEST_CASE("engines: free fall -> g t^2 / 2 in both") {
  const double steps = std::ceil(0.5 / 0.0012);
  const double expected_m = 9.81 * 0.0012 * 0.0012 * steps * (steps + 1.0) / 2.0;
  CHECK(std::abs(fallen_m<Mujoco>() - expected_m) < free_fall_m);
  CHECK(std::abs(fallen_m<Ode>() - expected_m) < free_fall_m);
}

TEST_CASE("engines: robot at rest -> the model's rest height") {
  CHECK(std::abs(resting_m<Mujoco>() - resting_m<Ode>()) < resting_height_m);
}

TEST_CASE("engines: spider and gecko in one world at rest -> equal heights in both, near those of their models") {
  const auto mujoco_m = resting_pair_m<Mujoco>();
  const auto ode_m = resting_pair_m<Ode>();
  for (const std::size_t robot : {0U, 1U}) {
    CHECK(std::abs(mujoco_m.at(robot) - ode_m.at(robot)) < resting_height_m);
    CHECK(std::abs(mujoco_m.at(robot)) < 0.002);  // servos give way by most of a millimetre in both
  }
}

TEST_CASE("engines: spider and gecko that move their hinges in the air -> equal angles and poses in both") {
  auto mujoco = swinging_pair<Mujoco>();
  auto ode = swinging_pair<Ode>();
  double widest_rad = 0.0;
  for (const double time_s : {0.02, 0.05, 0.1, 0.3}) {
    CAPTURE(time_s);
    mujoco.advance_to(time_s);
    ode.advance_to(time_s);
    for (const std::size_t robot : {0U, 1U}) {
      CAPTURE(robot);
      const auto angles_rad = mujoco.joint_angles(robot);
      REQUIRE(angles_rad.size() == (robot == 0 ? 4 : 6));
      for (std::size_t i = 0; i < angles_rad.size(); ++i) {
        CHECK(std::abs(angles_rad[i] - ode.joint_angles(robot)[i]) < 2.0 * step_response_rad);
        widest_rad = std::max(widest_rad, std::abs(angles_rad[i]));
      }
      CHECK((mujoco.pose(robot).position_m - ode.pose(robot).position_m).norm() < swinging_m);
      CHECK(mujoco.pose(robot).orientation.angularDistance(ode.pose(robot).orientation) < 2.0 * step_response_rad);
    }
  }
  CHECK(widest_rad > 0.3);
}

TEST_CASE("engines: robots at rest -> no energy gain") {
  const auto in_mujoco = after_a_minute_at_rest<Mujoco>(test::Resting{});
  CHECK(in_mujoco.gain_J() < 1e-9);
  CHECK(in_mujoco.drift_m() < 1e-9);
  const auto in_ode = after_a_minute_at_rest<Ode>(test::Resting{ode_trembling_J, 60.0 * ode_creep_m_s});
  CHECK(in_ode.gain_J() > 0.0);
  CHECK(in_ode.drift_m() > 0.0);
}

TEST_CASE("engines: robot at rest in MuJoCo -> contact forces sum to its weight") {
  const RobotModel robot = load_robot("spider");
  Mujoco backend{robot, load_arena("walled_square"), one_at(robot.rest_height_m), Physics{}, {}};
  backend.advance_to(3.0);
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "resting.xml").string();
  backend.save_mjcf(file);
  std::array<char, 500> error{};
  const backend::mujoco::ModelPtr model{mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size()))};
  REQUIRE_MESSAGE(model, error.data());
  const backend::mujoco::DataPtr data{mj_makeData(model.get())};
  mj_resetDataKeyframe(model.get(), data.get(), 0);
  mj_forward(model.get(), data.get());
  double force_N = 0.0;
  for (int i = 0; i < data->ncon; ++i) {
    std::array<mjtNum, 6> force{};
    mj_contactForce(model.get(), data.get(), i, force.data());
    force_N += force[0];  // the contact frame's first axis is the normal: up
  }
  CHECK(force_N == doctest::Approx(robot.mass_kg() * 9.81).epsilon(weight_share));
}

TEST_CASE("engines: robot at rest in ODE -> spring forces sum to its weight") {
  // With the default of 8 sweeps the springs are pressed 23 % less than the weight asks for: the solver has not converged.
  const Ode::Params params{.sweeps = 100};
  const RobotModel robot = load_robot("spider");
  Ode backend{robot, load_arena("walled_square"), one_at(robot.rest_height_m), Physics{}, params};
  backend.advance_to(3.0);
  const auto frames = link_frames(robot, backend.pose(0), backend.joint_angles(0));
  double force_N = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const Box& box : robot.links[i].boxes) {
      for (unsigned corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d sign{(corner & 1U) != 0 ? 1.0 : -1.0, (corner & 2U) != 0 ? 1.0 : -1.0,
                                   (corner & 4U) != 0 ? 1.0 : -1.0};
        const Eigen::Vector3d corner_m = box.centre_m + box.orientation * sign.cwiseProduct(box.half_extents_m);
        force_N -= params.contact_stiffness_N_m * std::min(0.0, (frames[i] * corner_m).z());
      }
    }
  }
  CHECK(force_N == doctest::Approx(robot.mass_kg() * 9.81).epsilon(weight_share));
}

TEST_CASE("engines: pendulum without servo -> analytic period") {
  const Pendulum pendulum;
  const double small_s =
      2.0 * std::numbers::pi * std::sqrt(Pendulum::inertia_kgm2() / (Pendulum::mass_kg * 9.81 * Pendulum::length_m));
  const double expected_s = small_s / agm(1.0, std::cos(pendulum.start_rad / 2.0));
  CHECK(period_s<Mujoco>() == doctest::Approx(expected_s).epsilon(period_share));
  CHECK(period_s<Ode>() == doctest::Approx(expected_s).epsilon(period_share));
}

TEST_CASE("engines: servo step -> analytic response") {
  const Pendulum pendulum{.servo = {.position_gain = 5.0, .velocity_gain = 0.05, .target_limit_rad = 1.0}};
  const std::array<double, 4> times_s{0.01, 0.02, 0.04, 0.08};
  const auto mujoco_rad = step_response_rad_at<Mujoco>(times_s, pendulum, 0.0002);
  const auto ode_rad = step_response_rad_at<Ode>(times_s, pendulum, 0.0002);
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(times_s[i]);
    const double exact_rad = exact_response_rad(times_s[i], pendulum.servo, Pendulum::inertia_kgm2(), 0.5);
    CHECK(std::abs(mujoco_rad[i] - exact_rad) < step_response_rad);
    CHECK(std::abs(ode_rad[i] - exact_rad) < step_response_rad);
  }
}

TEST_CASE("engines: collision -> momentum conserved (ODE at any timestep, MuJoCo as it goes to zero)") {
  const Collision ode = collide<Ode>(0.0012);
  CHECK(ode.drift_m < ode_drift_m);
  CHECK(ode.separation_m > 0.02);
  for (const double timestep_s : {0.0012, 0.0003}) {
    CAPTURE(timestep_s);
    const Collision mujoco = collide<Mujoco>(timestep_s);
    CHECK(mujoco.drift_m < mujoco_drift_m_per_s_step * timestep_s);
    CHECK(mujoco.separation_m > 0.02);
  }
}

TEST_CASE("engines: box on a slope -> slides as by Coulomb friction") {
  const double slope_rad = std::numbers::pi / 6.0;
  const double time_s = 0.6;
  const auto expected_m = [&](double friction) {
    return 0.5 * 9.81 * (std::sin(slope_rad) - friction * std::cos(slope_rad)) * time_s * time_s;
  };
  SUBCASE("along an axis of the friction pyramid: Coulomb's mu") {
    const Eigen::Vector2d along{1.0, 0.0};
    CHECK(slid_m<Mujoco>(slope_rad, along, 0.3, time_s) == doctest::Approx(expected_m(0.3)).epsilon(sliding_share));
    CHECK(slid_m<Ode>(slope_rad, along, 0.3, time_s) == doctest::Approx(expected_m(0.3)).epsilon(sliding_share));
  }
  SUBCASE("between two of them: both pyramids are flat there and give mu / sqrt(2)") {
    const Eigen::Vector2d between = Eigen::Vector2d{1.0, 1.0}.normalized();
    const double weaker = 0.3 / std::numbers::sqrt2;
    CHECK(slid_m<Mujoco>(slope_rad, between, 0.3, time_s) == doctest::Approx(expected_m(weaker)).epsilon(sliding_share));
    CHECK(slid_m<Ode>(slope_rad, between, 0.3, time_s) == doctest::Approx(expected_m(weaker)).epsilon(sliding_share));
  }
}

TEST_CASE("engines: force below the friction limit -> no sliding") {
  CHECK(slid_m<Mujoco>(0.2, {1.0, 0.0}, 0.5, 1.0) < creep_m_s * 1.0);
  CHECK(slid_m<Ode>(0.2, {1.0, 0.0}, 0.5, 1.0) < creep_m_s * 1.0);
}

TEST_CASE("engines: hinge beyond its range -> rests at the limit") {
  CHECK(std::abs(rest_angle_at_limit_rad<Mujoco>() + 0.4) < limit_rad);
  CHECK(std::abs(rest_angle_at_limit_rad<Ode>() + 0.4) < limit_rad);
}
