// SPDX-License-Identifier: MIT
// The contract of every backend that exchanges bodies: TEST_CASE_TEMPLATE_INVOKE(trophic_embodying_suite, MyBackend);
#pragma once

#include <conformance/backend_suite.hpp>
#include <trophic/params/archive.hpp>

namespace trophic::conformance {

/// Three spiders far apart; the middle one becomes a gecko. Servos are driven by sines, so that any body moves.
template <Embodying B>
struct Exchange {
  World<B> world{3};
  RobotModel gecko = load_robot("gecko");
  Pose place{.position_m = {1.0, -2.0, gecko.rest_height_m},
             .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{0.4, Eigen::Vector3d::UnitZ()}}};

  static void drive(B& backend, double from_s, double until_s) {
    const auto first = static_cast<int>(std::lround(60.0 * from_s));
    const auto end = static_cast<int>(std::lround(60.0 * until_s));
    for (int tick = first; tick < end; ++tick) {
      for (std::size_t robot = 0; robot < backend.robots(); ++robot) {
        std::vector<double> targets_rad(backend.model(robot).hinges.size());
        for (std::size_t i = 0; i < targets_rad.size(); ++i) {
          targets_rad[i] = 0.6 * std::sin(0.1 * tick + static_cast<double>(i + robot));
        }
        backend.set_joint_targets(robot, targets_rad);
      }
      backend.advance_to(static_cast<double>(tick + 1) / 60.0);
    }
  }

  [[nodiscard]] static std::string bytes_of(const B& backend) {
    auto state = backend.save();
    Archive archive;
    archive(state);
    return std::move(archive).bytes();
  }
};

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("exchange of bodies", B, trophic_embodying_suite) {
  using namespace trophic;
  using Exchange = conformance::Exchange<B>;
  const Exchange scene;
  B backend = scene.world.make();
  Exchange::drive(backend, 0.0, 0.5);
  const std::string before = Exchange::bytes_of(backend);

  SUBCASE("a new body stands at its pose, at rest, with angles of 0, and walks") {
    backend.embody(1, scene.gecko, scene.place);
    CHECK(backend.model(1).name == "gecko");
    CHECK(backend.model(0).name == "spider");
    CHECK((backend.pose(1).position_m - scene.place.position_m).norm() < 1e-12);
    REQUIRE(backend.joint_angles(1).size() == scene.gecko.hinges.size());
    for (const double angle_rad : backend.joint_angles(1)) CHECK(angle_rad == 0.0);
    CHECK(backend.time_s() == doctest::Approx(0.5).epsilon(0.01));
    backend.advance_to(1.0);
    CHECK((backend.pose(1).position_m - scene.place.position_m).norm() < 0.02);
    for (const double angle_rad : backend.joint_angles(1)) CHECK(std::abs(angle_rad) < 0.05);
    Exchange::drive(backend, 1.0, 2.0);
    double most_rad = 0.0;
    for (const double angle_rad : backend.joint_angles(1)) most_rad = std::max(most_rad, std::abs(angle_rad));
    CHECK(most_rad > 0.2);
  }
  SUBCASE("the others do not notice, bitwise") {
    B other = scene.world.make();
    Exchange::drive(other, 0.0, 0.5);
    backend.embody(1, scene.gecko, scene.place);
    Exchange::drive(backend, 0.5, 1.5);
    Exchange::drive(other, 0.5, 1.5);
    for (const std::size_t robot : {0U, 2U}) CHECK(conformance::seen(backend, robot) == conformance::seen(other, robot));
  }
  SUBCASE("a state with exchanged bodies is restored in a backend with the same ones, bitwise, and refused in another") {
    backend.embody(1, scene.gecko, scene.place);
    Exchange::drive(backend, 0.5, 1.0);
    B other = scene.world.make();
    CHECK_THROWS_AS(other.restore(backend.save()), std::invalid_argument);
    RobotModel stiffer = scene.gecko;
    stiffer.hinges.back().servo.position_gain *= 1.1;
    other.embody(1, stiffer, {.position_m = {0.0, 0.0, 1.0}});
    CHECK_THROWS_WITH_AS(other.restore(backend.save()), doctest::Contains("robot 1"), std::invalid_argument);
    other.embody(1, scene.gecko, {.position_m = {0.0, 0.0, 1.0}});
    other.restore(backend.save());
    CHECK(Exchange::bytes_of(other) == Exchange::bytes_of(backend));
    Exchange::drive(backend, 1.0, 1.5);
    Exchange::drive(other, 1.0, 1.5);
    CHECK(Exchange::bytes_of(other) == Exchange::bytes_of(backend));
  }
  SUBCASE("bodies exchanged there and back leave nothing behind") {
    B fresh = scene.world.make();
    const Pose start = scene.world.starts[1];
    backend.embody(1, scene.gecko, scene.place);
    backend.embody(1, scene.world.robot, start);
    B other = scene.world.make();
    Exchange::drive(other, 0.0, 0.5);
    other.embody(1, scene.world.robot, start);
    CHECK(Exchange::bytes_of(other) == Exchange::bytes_of(backend));
    Exchange::drive(backend, 0.5, 1.0);
    Exchange::drive(other, 0.5, 1.0);
    CHECK(Exchange::bytes_of(other) == Exchange::bytes_of(backend));
  }
  SUBCASE("two bodies that touch push each other apart") {
    Pose close = backend.pose(0);
    close.position_m.x() += 0.15;
    close.position_m.z() = scene.gecko.rest_height_m + 0.1;
    backend.embody(1, scene.gecko, close);
    backend.advance_to(3.0);
    for (std::size_t robot = 0; robot < 3; ++robot) {
      CHECK(backend.pose(robot).position_m.allFinite());
      CHECK(backend.pose(robot).position_m.z() > -0.01);
    }
  }
  SUBCASE("what the constructor refuses is refused, and changes nothing") {
    RobotModel broken = scene.gecko;
    broken.links[1].mass_kg = -1.0;
    CHECK_THROWS_AS(backend.embody(1, broken, scene.place), std::invalid_argument);
    CHECK_THROWS_AS(backend.embody(1, scene.gecko, {.position_m = {1e6, 0.0, 0.0}}), std::invalid_argument);
    CHECK_THROWS_AS(backend.embody(3, scene.gecko, scene.place), std::out_of_range);
    CHECK(Exchange::bytes_of(backend) == before);
    CHECK(backend.model(1).name == "spider");
  }
}
