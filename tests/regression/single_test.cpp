// SPDX-License-Identifier: MIT
// The kernel in single precision: one step against mj_step's, and robots that touch with each instruction set.
#define TROPHIC_LANES in_single
#include <kernel/reference.hpp>
#include <regression/pen.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("single precision: one step from thousands of random states -> mj_step's but for rounding") {
  const RobotModel robot = load_robot("spider");
  const Arena arena;
  Rng rng{1, Stream::user};
  Reference reference{robot, arena, {.timestep_s = backend::Mujoco::screening_timestep_s}};
  OnePack lanes{reference.constants};
  std::vector<double> differences;  ///< of velocities
  for (int group = 0; group < 500; ++group) {
    std::vector<RobotState> states;
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
      states.push_back(random_state(robot, arena, reference, rng));
      states.back().put(lanes.pack, lane);
    }
    REQUIRE(lanes.step(kernel::all_lanes) == kernel::all_lanes);
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
      states[lane].put(reference.data);
      reference.step();
      states[lane].get(lanes.pack, lane);
      differences.push_back(relative_difference(states[lane].qvel, reference.data.qvel, states[lane].qvel.size()));
    }
  }
  // A number is rounded by 6e-8 of its size, and a step has some hundred operations. In a state of thousands rounding decides
  // whether a corner touches the floor.
  const auto beyond = [&](double bound) {
    return std::ranges::count_if(differences, [&](double difference) { return difference > bound; });
  };
  MESSAGE("largest difference ", std::ranges::max(differences));
  CHECK(beyond(1e-4) <= 4);
  CHECK(beyond(0.01) == 0);
  CHECK(beyond(1e-9) > 3900);
}

TEST_CASE("golden: screening, robots that touch for long, each instruction set of the kernel -> same numbers") {
  check_pen("mujoco_touching_screening", backend::Mujoco::screening_timestep_s, 8);
}
