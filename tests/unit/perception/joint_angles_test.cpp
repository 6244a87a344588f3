// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <support/standing_spiders.hpp>
#include <trophic/perception/sensors/joint_angles.hpp>

using namespace trophic;
using perception::sensors::JointAngles;

TEST_CASE("joint angles: hinges -> over their range, 0 for those that are missing and without joints") {
  test::HandPopulation robots{{{}}};
  test::StandingSpiders spiders{robots.poses};
  spiders.angles_rad[1] = 0.5 * spiders.model.hinges[1].range_rad;
  Rng rng{1, Stream::user};
  View view = robots.view();
  CHECK(JointAngles<2>{}.sense(0, {}, view, rng) == std::array{0.0, 0.0});
  view.bodies = &spiders;
  CHECK(JointAngles<6>{}.sense(0, {}, view, rng) == std::array{0.0, 0.5, 0.0, 0.0, 0.0, 0.0});
}
