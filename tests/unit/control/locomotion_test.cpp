// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <support/toy_backend.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

using namespace trophic;

namespace {

/// A spider that takes control steps on a backend that keeps its joint targets.
struct Walker {
  explicit Walker(std::int64_t idle_steps)
      : backend{robot, load_arena("walled_square"), std::vector<Pose>(1), {}, {}},
        locomotion{robot, load_gait("spider_published"), {}, 1, {.idle_steps = idle_steps}} {}

  std::vector<double> targets_after(std::int64_t steps) {
    locomotion.advance(backend, steps, std::vector<double>{0.7});
    const auto targets = backend.joint_angles(0);
    return {targets.begin(), targets.end()};
  }

  RobotModel robot = load_robot("spider");
  test::ToyBackend backend;
  locomotion::Locomotion<control::steering::TargetedSteering> locomotion;
};

}  // namespace

TEST_CASE("locomotion: idle steps -> joints rest and time passes, then the gait starts") {
  Walker idle{2};
  Walker prompt{0};
  CHECK(idle.targets_after(2) == std::vector<double>(idle.robot.hinges.size()));
  CHECK(idle.backend.time_s() == 2.0 / 60.0);
  CHECK(idle.targets_after(3) == prompt.targets_after(3));
}

TEST_CASE("locomotion: a state saved in the idle steps -> restored, the same targets") {
  Walker first{3};
  first.targets_after(1);
  Walker second{3};
  second.locomotion.restore(first.locomotion.save());
  CHECK(first.targets_after(7) == second.targets_after(7));
}

TEST_CASE("locomotion: pace -> the gait that much faster or slower, standing at 0") {
  Walker plain{0};
  Walker paced{0};
  for (const auto& [pace, of_plain] : std::vector<std::pair<double, std::int64_t>>{{2.0, 20}, {0.5, 5}, {0.0, 0}, {1.3, 13}}) {
    paced.locomotion.set_paces({pace});
    CHECK(paced.targets_after(10) == plain.targets_after(of_plain));
  }
}

TEST_CASE("locomotion: reset -> the gait of a robot restarts") {
  Walker walker{0};
  const auto first = walker.targets_after(1);
  CHECK(walker.targets_after(30) != first);
  walker.locomotion.reset(0);
  CHECK(walker.targets_after(1) == first);
}
