// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <trophic/body/load.hpp>
#include <trophic/control/gait.hpp>
#include <trophic/evolve/cppn_gait.hpp>
#include <trophic/evolve/gait_file.hpp>

namespace control = trophic::control;
namespace evolve = trophic::evolve;

TEST_CASE("the gaits that were evolved for the shipped robots are their own CPPN at the robot's grid positions") {
  for (const std::string name : {"spider_paper", "spider_steered", "gecko_paper", "gecko_steered"}) {
    CAPTURE(name);
    const control::Gait gait = control::load_gait(name);
    CHECK(gait.name == name);
    const trophic::RobotModel robot = trophic::body::load_robot(gait.robot);
    REQUIRE_NOTHROW(control::check_fit(gait, robot));
    const control::Gait queried = evolve::cppn_gait(evolve::load_cppn(name), robot);
    CHECK((gait.internal - queried.internal).cwiseAbs().maxCoeff() < 1e-13);
    CHECK((gait.coupling - queried.coupling).cwiseAbs().maxCoeff() < 1e-13);
  }
}

TEST_CASE("each shipped robot names a gait that fits it") {
  for (const std::string name : {"spider", "spider_released", "gecko"}) {
    CAPTURE(name);
    const trophic::RobotModel robot = trophic::body::load_robot(name);
    CHECK_NOTHROW(control::check_fit(control::load_gait(robot.gait), robot));
  }
}
