// SPDX-License-Identifier: MIT
// The contract of every backend, as one doctest case: TEST_CASE_TEMPLATE_INVOKE(trophic_backend_suite, MyBackend);
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <trophic/backend/contract.hpp>
#include <trophic/control/locomotion/cpg.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>

namespace trophic::conformance {

/// A robot and the gait that it walks with.
struct Walker {
  std::string_view robot;
  std::string_view gait;
};
/// Four hinges and six: a backend takes any number.
inline constexpr std::array walkers{Walker{"spider", "spider_published"}, Walker{"gecko", "gecko_steered"}};

/// Robots in the walled square, with one backend and its default Params. They stand far from each other.
template <Backend B>
struct World {
  RobotModel robot;
  Arena arena = load_arena("walled_square");
  Physics physics;
  typename B::Params params;
  std::vector<Pose> starts;

  explicit World(std::size_t robots, const Walker& walker = walkers[0]) : robot{load_robot(walker.robot)} {
    for (std::size_t i = 0; i < robots; ++i) {
      const double yaw_rad = 0.5 + 2.0 * static_cast<double>(i);
      starts.push_back({.position_m = {-4.0 + 2.0 * static_cast<double>(i), 3.0 - static_cast<double>(i), robot.rest_height_m},
                        .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{yaw_rad, Eigen::Vector3d::UnitZ()}}});
    }
  }

  [[nodiscard]] B make() const { return B{robot, arena, starts, physics, params}; }
};

/// Walks every robot, by its gait or by target angles of +-`turn_rad`. A copy drives on exactly as the original would.
class Driver {
 public:
  explicit Driver(std::size_t robots, const Walker& walker = walkers[0], double turn_rad = 0.7)
      : Driver{robots, load_gait(walker.gait), load_gait(walker.gait).hinges.size(), turn_rad} {}

  template <Backend B>
  void drive(B& backend, double until_s) {
    for (; static_cast<double>(tick_) / 60.0 < until_s - 1e-9; ++tick_) {
      for (std::size_t robot = 0; robot < backend.robots(); ++robot) {
        if constexpr (JointDriven<B>) {
          cpg_.outputs(states_, robot, targets_rad_);
          backend.set_joint_targets(robot, targets_rad_);
        }
        if constexpr (SteeringDriven<B>) {
          backend.set_target_angle(robot, ((tick_ / 120 + robot) % 3 == 0 ? turn_rad_ : -turn_rad_));
        }
      }
      cpg_.step(states_);
      backend.advance_to(static_cast<double>(tick_ + 1) / 60.0);
    }
  }

 private:
  Driver(std::size_t robots, const Gait& gait, std::size_t hinges, double turn_rad)
      : cpg_{gait}, states_{cpg_.initial_states(robots)}, targets_rad_(hinges), turn_rad_{turn_rad} {}

  locomotion::Cpg cpg_;
  Eigen::MatrixXd states_;
  std::vector<double> targets_rad_;
  double turn_rad_;
  std::size_t tick_ = 0;
};

/// The numbers of one robot that can be seen.
template <Backend B>
[[nodiscard]] std::vector<double> seen(const B& backend, std::size_t robot) {
  const Pose pose = backend.pose(robot);
  std::vector<double> numbers(pose.position_m.data(), pose.position_m.data() + 3);
  numbers.insert(numbers.end(), pose.orientation.coeffs().data(), pose.orientation.coeffs().data() + 4);
  const std::span<const double> angles = backend.joint_angles(robot);
  numbers.insert(numbers.end(), angles.begin(), angles.end());
  return numbers;
}

/// All that can be seen of a backend, number by number.
template <Backend B>
[[nodiscard]] std::vector<double> observe(const B& backend) {
  std::vector<double> all{backend.time_s()};
  for (std::size_t robot = 0; robot < backend.robots(); ++robot) {
    const std::vector<double> own = seen(backend, robot);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

template <Backend B>
void check_names() {
  CHECK_FALSE(std::string{B::name}.empty());
  CHECK_FALSE(B::version().empty());
}

/// Asking for a robot that is not there is an error, not another robot's numbers.
template <Backend B>
void check_missing_robots() {
  const World<B> world{2};
  B backend = world.make();
  const std::vector<double> before = observe(backend);
  CHECK_THROWS_AS(static_cast<void>(backend.pose(2)), std::out_of_range);
  if constexpr (JointDriven<B>) {
    CHECK_THROWS_AS(static_cast<void>(backend.joint_angles(2)), std::out_of_range);
    const std::vector<double> targets_rad(world.robot.hinges.size(), 0.1);
    CHECK_THROWS_AS(backend.set_joint_targets(2, targets_rad), std::out_of_range);
  }
  if constexpr (SteeringDriven<B>) CHECK_THROWS_AS(backend.set_target_angle(2, 0.1), std::out_of_range);
  CHECK(observe(backend) == before);
}

template <Backend B>
void check_starts(const Walker& walker) {
  for (const std::size_t robots : {std::size_t{1}, std::size_t{4}}) {
    const World<B> world{robots, walker};
    const B backend = world.make();
    CHECK(backend.robots() == robots);
    CHECK(backend.time_s() == 0.0);
    for (std::size_t i = 0; i < robots; ++i) {
      const Pose pose = backend.pose(i);
      CHECK((pose.position_m - world.starts[i].position_m).norm() < 1e-9);
      CHECK(pose.orientation.angularDistance(world.starts[i].orientation) < 1e-7);
      CHECK(std::abs(pose.orientation.norm() - 1.0) < 1e-9);
      const std::span<const double> angles = backend.joint_angles(i);
      CHECK((angles.empty() || angles.size() == world.robot.hinges.size()));
      if constexpr (JointDriven<B>) CHECK(angles.size() == world.robot.hinges.size());
      for (const double angle_rad : angles) CHECK(angle_rad == 0.0);
    }
  }
}

template <Backend B>
void check_time() {
  B backend = World<B>{1}.make();
  backend.advance_to(1e-6);
  const double step_s = backend.time_s();
  CHECK(step_s > 0.0);
  backend.advance_to(2.5 * step_s);
  CHECK(backend.time_s() == doctest::Approx(3.0 * step_s).epsilon(1e-12));
  backend.advance_to(3.0 * step_s + 5e-10);  // within the slack
  CHECK(backend.time_s() == doctest::Approx(3.0 * step_s).epsilon(1e-12));
  backend.advance_to(4.0 * step_s);
  CHECK(backend.time_s() == doctest::Approx(4.0 * step_s).epsilon(1e-12));
  const std::vector<double> before = observe(backend);
  backend.advance_to(2.0 * step_s);
  backend.advance_to(-1.0);
  CHECK(observe(backend) == before);
  // No drift of the clock and no step too many over many small advances.
  for (int i = 5; i <= 500; ++i) backend.advance_to(i * step_s);
  CHECK(backend.time_s() == doctest::Approx(500.0 * step_s).epsilon(1e-12));
}

/// Many short advances and one long one agree.
template <Backend B>
void check_pieces() {
  B pieces = World<B>{2}.make();
  B whole = World<B>{2}.make();
  for (int i = 1; i <= 37; ++i) pieces.advance_to(i * 0.013);
  whole.advance_to(37 * 0.013);
  CHECK(observe(pieces) == observe(whole));
}

template <Backend B>
void check_independence() {
  const World<B> world{3};
  B one = world.make();
  B other = world.make();
  const std::vector<double> untouched = observe(other);
  Driver driver_of_one{3};
  Driver driver_of_other{3};
  driver_of_one.drive(one, 2.0);
  CHECK(observe(other) == untouched);
  CHECK(observe(one) != untouched);
  driver_of_other.drive(other, 2.0);
  CHECK(observe(other) == observe(one));
}

template <Backend B>
void check_restore(const Walker& walker) {
  const World<B> world{3, walker};
  B backend = world.make();
  Driver driver{3, walker};
  driver.drive(backend, 1.5);
  const typename B::State state = backend.save();
  const std::vector<double> then = observe(backend);
  Driver again = driver;
  driver.drive(backend, 3.0);
  const std::vector<double> later = observe(backend);

  B fresh = world.make();
  fresh.restore(state);
  CHECK(observe(fresh) == then);
  Driver for_fresh = again;
  for_fresh.drive(fresh, 3.0);
  CHECK(observe(fresh) == later);

  backend.restore(state);
  CHECK(observe(backend) == then);
  again.drive(backend, 3.0);
  CHECK(observe(backend) == later);
}

/// Commands before the save still hold after the restore.
template <Backend B>
void check_restored_commands() {
  const World<B> world{2};
  B backend = world.make();
  Driver driver{2};
  driver.drive(backend, 1.0);
  B fresh = world.make();
  fresh.restore(backend.save());
  backend.advance_to(1.5);
  fresh.advance_to(1.5);
  CHECK(observe(fresh) == observe(backend));
}

template <Backend B>
void check_walls() {
  World<B> world{4};
  for (std::size_t i = 0; i < 4; ++i) {
    // One robot at each wall, its forward axis towards it.
    const double outward_rad = std::numbers::pi / 2.0 * static_cast<double>(i);
    const double from_centre_m = world.arena.half_side_m - 0.25;
    world.starts[i].position_m = {from_centre_m * std::cos(outward_rad), from_centre_m * std::sin(outward_rad),
                                  world.robot.rest_height_m};
    world.starts[i].orientation = Eigen::AngleAxisd{outward_rad - world.robot.forward_rad, Eigen::Vector3d::UnitZ()};
  }
  B backend = world.make();
  Driver driver{4, walkers[0], 0.0};
  for (double time_s = 1.0; time_s <= 15.0; time_s += 1.0) {
    driver.drive(backend, time_s);
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d at = backend.pose(i).position_m;
      CHECK(std::max(std::abs(at.x()), std::abs(at.y())) <= world.arena.half_side_m);
      CHECK(at.z() > 0.0);
    }
  }
}

/// A number of Physics that changes nothing is named in a remark.
template <Backend B>
void check_remarks() {
  const auto fall = [](const Physics& physics) {
    World<B> world{1};
    world.physics = physics;
    world.starts[0].position_m.z() = 1.0;
    B backend = world.make();
    backend.advance_to(0.3);
    return observe(backend);
  };
  const std::vector<double> usual = fall({});
  const auto check = [&](std::string_view field, const Physics& changed) {
    CAPTURE(field);
    std::string remarks;
    for (const std::string& remark : B::remarks(changed)) {
      CHECK(remark.find('\n') == std::string::npos);
      remarks += remark;
    }
    if (fall(changed) == usual) CHECK(remarks.find("physics." + std::string{field}) != std::string::npos);
  };
  check("timestep_s", {.timestep_s = 0.003});
  check("integrator", {.integrator = Integrator::rk4});
  check("gravity_m_s2", {.gravity_m_s2 = 3.7});
}

template <Backend B, class Change>
[[nodiscard]] std::string complaint(Change&& change) {
  World<B> world{1};
  change(world);
  try {
    (void)world.make();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

template <Backend B>
void check_bad_numbers() {
  const auto names = [](const std::string& message, std::string_view field) { return message.find(field) != std::string::npos; };
  CHECK(names(complaint<B>([](auto& world) { world.physics.timestep_s = 0.0; }), "timestep_s"));
  CHECK(names(complaint<B>([](auto& world) { world.physics.timestep_s = std::nan(""); }), "timestep_s"));
  CHECK(names(complaint<B>([](auto& world) { world.physics.gravity_m_s2 = -1.0; }), "gravity_m_s2"));
  CHECK(names(complaint<B>([](auto& world) { world.starts.clear(); }), "robots"));
  typename B::Params defaults;
  for_each_field(defaults, [&](const auto& f, const auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_floating_point_v<T>) {
      CAPTURE(f.name);
      CHECK(names(complaint<B>([&](auto& world) { world.params.*(f.member) = std::numeric_limits<T>::quiet_NaN(); }), f.name));
      if (std::isfinite(f.bound.lower)) {
        CHECK(names(complaint<B>([&](auto& world) { world.params.*(f.member) = static_cast<T>(f.bound.lower) - 1; }), f.name));
      }
    }
  });
}

/// Without weight the servos reach their targets; targets beyond the limit are clipped to it.
template <JointDriven B>
void check_servos(const Walker& walker) {
  World<B> world{2, walker};
  world.physics.gravity_m_s2 = 0.0;
  for (Pose& start : world.starts) start.position_m.z() = 1.0;
  B backend = world.make();
  const std::array<double, 4> targets_rad{0.3, -0.8, 5.0, -5.0};
  const std::array<double, 4> reached_rad{0.3, -0.8, 1.0, -1.0};
  std::vector<double> asked_rad;
  for (std::size_t hinge = 0; hinge < world.robot.hinges.size(); ++hinge) asked_rad.push_back(targets_rad[hinge % 4]);
  backend.set_joint_targets(1, asked_rad);
  backend.advance_to(3.0);
  for (std::size_t hinge = 0; hinge < asked_rad.size(); ++hinge) {
    CAPTURE(hinge);
    CHECK(std::abs(backend.joint_angles(0)[hinge]) < 1e-9);
    CHECK(std::abs(backend.joint_angles(1)[hinge] - reached_rad[hinge % 4]) < 1e-3);
  }
}

/// Falls as gravity says, and comes to rest on the floor at the model's rest height.
template <JointDriven B>
void check_fall_and_rest() {
  World<B> world{1};
  world.starts[0].position_m.z() = 1.0;
  B falling = world.make();
  falling.advance_to(0.3);
  const double fallen_m = 0.5 * world.physics.gravity_m_s2 * falling.time_s() * falling.time_s();
  CHECK(std::abs(falling.pose(0).position_m.z() - (1.0 - fallen_m)) < 0.005);

  world.starts[0].position_m.z() = world.robot.rest_height_m;
  B resting = world.make();
  resting.advance_to(3.0);
  const Pose then = resting.pose(0);
  CHECK(std::abs(then.position_m.z() - world.robot.rest_height_m) < 0.003);
  CHECK((then.position_m - world.starts[0].position_m).head(2).norm() < 0.01);
  CHECK((then.orientation * Eigen::Vector3d::UnitZ()).z() > 0.999);
  resting.advance_to(4.0);
  CHECK((resting.pose(0).position_m - then.position_m).norm() < 0.001);
}

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("backend conformance", B, trophic_backend_suite) {
  using namespace trophic::conformance;
  static_assert(trophic::Backend<B>);
  static_assert(trophic::JointDriven<B> || trophic::SteeringDriven<B>, "a backend must be JointDriven or SteeringDriven");
  SUBCASE("has a name and a version") {
    check_names<B>();
  }
  SUBCASE("remarks on numbers of the physics without effect") {
    check_remarks<B>();
  }
  SUBCASE("starts at the given poses") {
    for (const Walker& walker : walkers) check_starts<B>(walker);
  }
  SUBCASE("rejects robots that do not exist") {
    check_missing_robots<B>();
  }
  SUBCASE("advances by whole steps, never back") {
    check_time<B>();
  }
  SUBCASE("takes the same steps in pieces") {
    check_pieces<B>();
  }
  SUBCASE("two instances are independent and do the same") {
    check_independence<B>();
  }
  SUBCASE("a restored state continues bitwise") {
    for (const Walker& walker : walkers) check_restore<B>(walker);
  }
  SUBCASE("a restored state keeps its commands") {
    check_restored_commands<B>();
  }
  SUBCASE("robots stay between the walls") {
    check_walls<B>();
  }
  SUBCASE("rejects bad numbers by name") {
    check_bad_numbers<B>();
  }
  if constexpr (trophic::JointDriven<B>) {
    SUBCASE("servos reach their targets") {
      for (const Walker& walker : walkers) check_servos<B>(walker);
    }
    SUBCASE("falls, then rests on the floor") {
      check_fall_and_rest<B>();
    }
  }
}
