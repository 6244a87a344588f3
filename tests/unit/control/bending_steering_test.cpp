// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/control/steering/bending_steering.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

using namespace trophic;
using control::steering::BendingSteering;

TEST_CASE("hinge places: snake -> all behind the core, in the middle, the first two and the last sweep") {
  const std::vector<HingePlace> places = hinge_places(load_robot("snake"));
  REQUIRE(places.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(places[i].side == Side::middle);
    CHECK(places[i].ahead == -1.0 - static_cast<double>(i));
    CHECK(std::abs(places[i].upright) == doctest::Approx(i < 2 || i == 4 ? 1.0 : 0.0).epsilon(1e-9));
  }
}

TEST_CASE("bending steering: target angle -> an offset of hinges that sweep, opposite ahead of the core") {
  const BendingSteering steering{{.bend = 0.5}};
  std::vector<double> targets_rad{0.1, 0.2, 0.3, 0.4};
  steering.steer(0.6,
                 std::vector<HingePlace>{
                     {.ahead = -1.0, .upright = 1.0}, {.upright = -1.0}, {.upright = 0.1}, {.ahead = 2.0, .upright = 1.0}},
                 targets_rad);
  CHECK(targets_rad == std::vector<double>{0.1 + 0.3, 0.2 - 0.3, 0.3, 0.4 - 0.3});
}
