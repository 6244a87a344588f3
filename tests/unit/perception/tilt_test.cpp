// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <support/standing_spiders.hpp>
#include <trophic/perception/sensors/tilt.hpp>
#include <trophic/perception/sensors/touch.hpp>

using namespace trophic;
using perception::sensors::Tilt;
using perception::sensors::Touch;

TEST_CASE("tilt: angle to the vertical -> over pi, 0 without joints") {
  test::HandPopulation robots{{{}, {.x_m = 5.0}}};
  test::StandingSpiders spiders{robots.poses};
  spiders.roots[1].orientation = Eigen::AngleAxisd{std::numbers::pi / 2.0, Eigen::Vector3d::UnitX()};
  Rng rng{1, Stream::user};
  View view = robots.view();
  CHECK(Tilt{}.sense(1, {}, view, rng) == std::array{0.0});
  view.bodies = &spiders;
  CHECK(Tilt{}.sense(0, {}, view, rng)[0] == doctest::Approx(0.0).epsilon(1e-9));
  CHECK(Tilt{}.sense(1, {}, view, rng)[0] == doctest::Approx(0.5).epsilon(1e-9));
}

TEST_CASE("touch: wall or obstacle, robot -> 1 each, and a body without an individual is not touched") {
  test::HandPopulation robots{{{}, {.x_m = 0.2}, {.x_m = 5.0}, {.x_m = 9.9}}};
  const test::StandingSpiders spiders{robots.poses};
  Rng rng{1, Stream::user};
  View view = robots.view();
  const auto touches = [&](BodyIndex body) { return Touch{}.sense(body, {}, view, rng); };
  CHECK(touches(0) == std::array{0.0, 0.0});
  view.bodies = &spiders;
  CHECK(touches(0) == std::array{0.0, 1.0});
  CHECK(touches(1) == std::array{0.0, 1.0});
  CHECK(touches(2) == std::array{0.0, 0.0});
  CHECK(touches(3) == std::array{1.0, 0.0});
  robots.individuals[1] = spare_body(1, 0.0);
  CHECK(touches(0) == std::array{0.0, 0.0});
  robots.arena.obstacles = {{.x_m = 5.0, .to_x_m = 5.0, .radius_m = 0.05}};
  CHECK(touches(2) == std::array{1.0, 0.0});
}
