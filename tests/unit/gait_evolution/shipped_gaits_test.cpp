// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <support/temporary_folder.hpp>
#include <tools/gait_evolution/cppn_gait.hpp>
#include <tools/gait_evolution/gait_file.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>

using trophic::Gait;
using trophic::load_gait;
namespace gait_evolution = trophic::gait_evolution;

TEST_CASE("shipped gaits: each evolved gait -> its own CPPN at the robot's grid positions") {
  for (const std::string name : {"spider_paper", "spider_steered", "gecko_paper", "gecko_steered"}) {
    CAPTURE(name);
    const Gait gait = load_gait(name);
    CHECK(gait.name == name);
    const trophic::RobotModel robot = trophic::load_robot(gait.robot);
    REQUIRE_NOTHROW(check_fit(gait, robot));
    const Gait queried = gait_evolution::cppn_gait(gait_evolution::load_cppn(name), robot);
    CHECK((gait.internal - queried.internal).cwiseAbs().maxCoeff() < 1e-13);
    CHECK((gait.coupling - queried.coupling).cwiseAbs().maxCoeff() < 1e-13);
  }
}

TEST_CASE("each shipped robot names a gait that fits it") {
  for (const std::string name : {"spider", "spider_released", "gecko"}) {
    CAPTURE(name);
    const trophic::RobotModel robot = trophic::load_robot(name);
    CHECK_NOTHROW(check_fit(load_gait(robot.gait), robot));
  }
}

TEST_CASE("gait file: written and loaded -> same bits") {
  const trophic::test::TemporaryFolder folder;
  Gait gait = load_gait("gecko_paper");
  gait.name = "quotes \" and \\ and spaces";
  gait.internal << 0.1, 1.0 / 3.0, -1e-300, 5e300, 3.0, -0.0;
  trophic::TomlWriter writer;
  gait_evolution::put_gait(writer, gait);
  const Gait again = load_gait(folder.file("gait.toml", writer.text()));
  CHECK(again == gait);
  CHECK(std::signbit(again.internal[5]));
}
