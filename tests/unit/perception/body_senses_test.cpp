// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/perception/sensors/joint_angles.hpp>
#include <trophic/perception/sensors/tilt.hpp>
#include <trophic/perception/sensors/touch.hpp>

using namespace trophic;
using namespace trophic::perception::sensors;

namespace {

/// Spiders at places in space.
struct Spiders final : BodyReading {
  RobotModel model = load_robot("spider");
  std::vector<Pose> roots;
  std::vector<double> angles_rad = std::vector<double>(model.hinges.size(), 0.0);
  [[nodiscard]] const RobotModel& robot(BodyIndex) const override { return model; }
  [[nodiscard]] Pose root(BodyIndex body) const override { return roots[body]; }
  [[nodiscard]] std::span<const double> joint_angles_rad(BodyIndex) const override { return angles_rad; }
};

}  // namespace

TEST_CASE("senses of the body: joints over their range, tilt over pi, touch by the boxes; 0 without joints") {
  test::HandPopulation robots{{{}, {.x_m = 0.2}, {.x_m = 5.0}, {.x_m = 9.9}}};
  Spiders spiders;
  for (const GroundPose& at : robots.poses)
    spiders.roots.push_back({.position_m = {at.x_m, at.y_m, spiders.model.rest_height_m}});
  spiders.roots[2].orientation = Eigen::AngleAxisd{std::numbers::pi / 2.0, Eigen::Vector3d::UnitX()};
  spiders.angles_rad[1] = 0.5 * spiders.model.hinges[1].range_rad;
  Rng rng{1, Stream::user};
  View view = robots.view();
  CHECK(JointAngles<2>{}.sense(0, {}, view, rng) == std::array{0.0, 0.0});
  CHECK(Tilt{}.sense(2, {}, view, rng) == std::array{0.0});
  CHECK(Touch{}.sense(0, {}, view, rng) == std::array{0.0, 0.0});
  view.bodies = &spiders;
  CHECK(JointAngles<6>{}.sense(0, {}, view, rng) == std::array{0.0, 0.5, 0.0, 0.0, 0.0, 0.0});
  CHECK(Tilt{}.sense(0, {}, view, rng)[0] == doctest::Approx(0.0).epsilon(1e-9));
  CHECK(Tilt{}.sense(2, {}, view, rng)[0] == doctest::Approx(0.5).epsilon(1e-9));
  const auto touches = [&](BodyIndex body) { return Touch{}.sense(body, {}, view, rng); };
  CHECK(touches(0) == std::array{0.0, 1.0});
  CHECK(touches(1) == std::array{0.0, 1.0});
  CHECK(touches(2) == std::array{0.0, 0.0});
  CHECK(touches(3) == std::array{1.0, 0.0});
  robots.individuals[1] = spare_body(1, 0.0);
  CHECK(touches(0) == std::array{0.0, 0.0});
  robots.arena.obstacles = {{.x_m = 5.0, .to_x_m = 5.0, .radius_m = 0.05}};
  CHECK(touches(2) == std::array{1.0, 0.0});
}
