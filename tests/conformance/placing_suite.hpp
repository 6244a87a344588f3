// SPDX-License-Identifier: MIT
// The contract of every backend whose robots come and go: TEST_CASE_TEMPLATE_INVOKE(trophic_placing_suite, MyBackend);
#pragma once

#include <conformance/backend_suite.hpp>
#include <trophic/params/archive.hpp>

TEST_CASE_TEMPLATE_DEFINE("robots that come and go", B, trophic_placing_suite) {
  using namespace trophic;
  using conformance::seen;
  static_assert(Placing<B>);
  const conformance::World<B> world{3};
  B backend = world.make();
  conformance::Driver driver{3};
  driver.drive(backend, 0.5);

  SUBCASE("all are there at first; a robot that does not exist is an error") {
    for (std::size_t robot = 0; robot < 3; ++robot) CHECK(backend.is_there(robot));
    CHECK_THROWS_AS(backend.take_away(3), std::out_of_range);
    CHECK_THROWS_AS(backend.place(3, world.starts[0]), std::out_of_range);
    CHECK_THROWS_AS(static_cast<void>(backend.is_there(3)), std::out_of_range);
    CHECK_THROWS_AS(backend.place(1, Pose{.position_m = {99.0, 0.0, 1.0}}), std::invalid_argument);
    CHECK(backend.is_there(1));
  }
  SUBCASE("who is away does not move, and the others do not notice, bitwise") {
    B other = world.make();
    conformance::Driver same{3};
    same.drive(other, 0.5);
    backend.take_away(1);
    CHECK_FALSE(backend.is_there(1));
    const std::vector<double> before = seen(backend, 1);
    driver.drive(backend, 2.0);
    same.drive(other, 2.0);
    CHECK(seen(backend, 1) == before);
    for (const std::size_t robot : {std::size_t{0}, std::size_t{2}}) {
      if constexpr (requires { requires B::rounds_with_others; }) {
        CHECK((backend.pose(robot).position_m - other.pose(robot).position_m).norm() < 1e-3);
      } else {
        CHECK(seen(backend, robot) == seen(other, robot));
      }
    }
  }
  SUBCASE("who is away does not block the way; who is placed stands there at rest, and moves again") {
    backend.take_away(0);
    backend.take_away(1);
    const Pose here = backend.pose(2);
    Pose there = world.starts[1];
    there.position_m.head<2>() = here.position_m.head<2>();
    backend.place(1, world.starts[1]);
    backend.take_away(1);
    backend.take_away(2);
    backend.place(1, there);  // where robot 2 was
    CHECK(backend.is_there(1));
    CHECK((backend.pose(1).position_m - there.position_m).norm() < 1e-12);
    for (const double angle_rad : backend.joint_angles(1)) CHECK(angle_rad == 0.0);
    B alone = conformance::World<B>{1}.make();
    alone.place(0, there);
    if constexpr (JointDriven<B>) {
      backend.advance_to(backend.time_s() + 0.5);
      alone.advance_to(0.5);
      CHECK((backend.pose(1).position_m - alone.pose(0).position_m).norm() < 1e-9);
    }
    driver.drive(backend, 3.0);
    CHECK((backend.pose(1).position_m - there.position_m).norm() > 0.005);
  }
  SUBCASE("a state holds who is there, in checkpoints too") {
    backend.take_away(2);
    driver.drive(backend, 1.0);
    Archive written;
    auto state = backend.save();
    written(state);
    Archive read{written.bytes()};
    auto again = backend.save();
    read(again);
    B other = world.make();
    other.restore(again);
    CHECK_FALSE(other.is_there(2));
    CHECK(other.is_there(0));
    conformance::Driver same = driver;
    driver.drive(backend, 1.5);
    same.drive(other, 1.5);
    CHECK(conformance::observe(other) == conformance::observe(backend));
  }
  SUBCASE("all are away") {
    for (std::size_t robot = 0; robot < 3; ++robot) backend.take_away(robot);
    const std::vector<double> before = seen(backend, 0);
    driver.drive(backend, 1.0);
    CHECK(seen(backend, 0) == before);
    CHECK(backend.time_s() == doctest::Approx(1.0).epsilon(0.02));
  }
}
