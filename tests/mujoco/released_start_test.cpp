// SPDX-License-Identifier: MIT
// The first second of the released code's robots against the poses that its authors logged.
#include <doctest/doctest.h>

#include <algorithm>
#include <trophic/backend/mujoco.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/ecology/standing_poses.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/initialization/placement/uniform_square.hpp>
#include <trophic/perception/heading/root_yaw_heading.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/units.hpp>
#include <vector>

using namespace trophic;

namespace {

/// Headings at 0.80 s as the authors' logs write them, of the robots that start clear of others and of the slope.
struct Headings {
  double mean_rad = 0.0;
  double deviation_rad = 0.0;
};

/// The authors' code reads the root's quaternion in another order of components, so that its heading is pi less ours.
double as_logged_rad(double heading_rad) {
  return wrap_angle(std::numbers::pi - heading_rad);
}

/// Robots of `Released` at 0.80 s, after so many control periods without control.
Headings headings_at_0_80_s(std::size_t idle_control_steps) {
  const EcologyParams ecology = rules::Released::ecology();
  const Habitat habitat = load_habitat(ecology);
  Rng rng{1, Stream::placement};
  const initialization::placement::UniformSquare placement{rules::Released::params().placement};
  const auto places = placement.place(ecology.robots, habitat.arena, habitat.robot.bounding_radius_m, rng);
  backend::Mujoco backend{
      habitat.robot, habitat.arena, standing_poses(places, habitat.robot, habitat.arena), rules::Released::physics(), {}};
  locomotion::Locomotion<control::steering::TargetedSteering> locomotion{
      habitat.robot,
      habitat.gait,
      {},
      ecology.robots,
      {.hz = ecology.control_hz,
       .integration = ecology.cpg_integration,
       .idle_steps = static_cast<std::int64_t>(idle_control_steps)}};
  locomotion.advance(backend, 48, std::vector<double>(ecology.robots, 0.0));

  std::vector<double> headings_rad;
  for (std::size_t robot = 0; robot < ecology.robots; ++robot) {
    const auto touches = [&](const GroundPose& other) {
      return &other != &places[robot] && distance_m(other, places[robot]) < 2.0 * habitat.robot.bounding_radius_m;
    };
    const double reach_m = std::max(std::abs(places[robot].x_m), std::abs(places[robot].y_m)) + habitat.robot.bounding_radius_m;
    if (std::ranges::any_of(places, touches) || reach_m > habitat.arena.half_side_m) continue;
    const double heading_rad = perception::heading::RootYawHeading{}.heading_rad(backend.pose(robot), habitat.robot.forward_rad);
    headings_rad.push_back(as_logged_rad(heading_rad));
  }
  const auto count = static_cast<double>(headings_rad.size());
  Headings result;
  for (const double rad : headings_rad) result.mean_rad += rad / count;
  for (const double rad : headings_rad) result.deviation_rad += (rad - result.mean_rad) * (rad - result.mean_rad) / count;
  result.deviation_rad = std::sqrt(result.deviation_rad);
  MESSAGE(count << " robots, " << idle_control_steps << " idle: " << result.mean_rad << " rad, deviation "
                << result.deviation_rad);
  return result;
}

}  // namespace

/// The authors' logs give a mean of -1.484 and a deviation of 0.06.
TEST_CASE("released start: one idle control period -> headings at 0.80 s as logged") {
  REQUIRE(rules::Released::ecology().idle_control_steps == 1);
  const Headings ours = headings_at_0_80_s(1);
  CHECK(std::abs(ours.mean_rad - -1.484) < 0.1);
  CHECK(ours.deviation_rad < 0.15);  // 0.18 without the idle period
}

TEST_CASE("released start: control from the first step -> headings far from those logged") {
  CHECK(std::abs(headings_at_0_80_s(0).mean_rad - -1.484) > 0.3);
}
