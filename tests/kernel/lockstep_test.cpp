// SPDX-License-Identifier: MIT
// The kernel against mj_step from the same random states: one step, any robot.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <trophic/habitat/load/robot.hpp>

#include "kernel/random_robot.hpp"
#include "kernel/reference.hpp"

using namespace trophic;
using namespace trophic::test;

namespace {

/// Result of a comparison of many steps.
struct Comparison {
  std::size_t steps = 0;
  std::size_t contacts = 0;
  std::size_t limits = 0;
  std::size_t declined = 0;
  std::size_t touching = 0;  ///< steps in which links of the robot touched each other
  double acceleration = 0.0;
  double velocity = 0.0;
  double position = 0.0;

  void compare(const RobotState& after, const mjModel& model, const mjData& data) {
    if (has_ties(model, data)) return;
    ++steps;
    bool links_touch = false;
    for (int c = 0; c < data.ncon; ++c) links_touch |= model.geom_bodyid[data.contact[c].geom1] != 0;
    for (int row = 0; row < data.nefc; ++row) limits += data.efc_type[row] == mjCNSTR_LIMIT_JOINT ? 1 : 0;
    touching += links_touch ? 1 : 0;
    contacts += static_cast<std::size_t>(data.ncon);
    acceleration = std::max(acceleration, relative_difference(after.warm, data.qacc_warmstart, after.warm.size()));
    velocity = std::max(velocity, relative_difference(after.qvel, data.qvel, after.qvel.size()));
    position = std::max(position, relative_difference(after.qpos, data.qpos, after.qpos.size()));
  }

  void report(const std::string& name) const {
    MESSAGE(name << ": " << steps << " steps, " << contacts << " contacts, " << touching << " steps with links touching, "
                 << limits << " joint limits, " << declined << " left to MuJoCo; acceleration " << acceleration << ", velocity "
                 << velocity << ", position " << position);
  }

  [[nodiscard]] bool agrees() const { return acceleration < 1e-10 && velocity < 1e-10 && position < 1e-12; }
};

/// Steps `groups` times four random states of a robot.
void compare_random_states(const RobotModel& robot, const Physics& physics, std::size_t groups, Rng& rng, Comparison& comparison,
                           double joint_damping = 0.0, BoxDepth depth = BoxDepth::engine) {
  const Arena arena;
  Reference reference{robot, arena, physics, joint_damping, depth};
  OnePack lanes{reference.constants};
  for (std::size_t group = 0; group < groups; ++group) {
    std::vector<RobotState> states;
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
      states.push_back(random_state(robot, arena, reference, rng));
      states.back().put(lanes.pack, lane);
    }
    const unsigned stepped = lanes.step(0xfu);
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
      RobotState after = states[lane];
      after.get(lanes.pack, lane);
      if ((stepped & (1u << lane)) == 0) {
        ++comparison.declined;
        CHECK(relative_difference(after.qpos, states[lane].qpos, after.qpos.size()) < 1e-15);
        CHECK(after.qvel == states[lane].qvel);
        CHECK(after.warm == states[lane].warm);
        continue;
      }
      states[lane].put(reference.data);
      reference.step();
      comparison.compare(after, reference.model, reference.data);
    }
  }
}

void check_robot(const std::string& name, const Physics& physics, std::size_t groups, double joint_damping = 0.0) {
  Rng rng{1, Stream::user};
  Comparison comparison;
  compare_random_states(load_robot(name), physics, groups, rng, comparison, joint_damping);
  comparison.report(name);
  CHECK(comparison.agrees());
  CHECK(comparison.steps > groups * 3);
  CHECK(comparison.contacts > comparison.steps * 2);
  CHECK(comparison.limits > comparison.steps / 20);
}

}  // namespace

TEST_CASE("kernel step: Euler, thousands of random states -> mj_step's") {
  check_robot("spider", {}, 1000);
  check_robot("gecko", {}, 1000);
  check_robot("spider_released", {}, 500);
}

TEST_CASE("kernel step: Euler, another gravity and timesteps, one beyond the contacts' time constant -> mj_step's") {
  check_robot("spider", {.timestep_s = 0.003, .gravity_m_s2 = 3.7}, 250);
  check_robot("spider", {.timestep_s = 0.012}, 250);
}

TEST_CASE("kernel step: Runge-Kutta, thousands of random states -> mj_step's") {
  check_robot("spider", {.integrator = Integrator::rk4}, 500);
  check_robot("gecko", {.integrator = Integrator::rk4}, 500);
  check_robot("spider_released", {.timestep_s = 0.012, .integrator = Integrator::rk4}, 500);
}

TEST_CASE("kernel step: joint damping -> mj_step's") {
  check_robot("spider", {}, 250, 0.02);
  check_robot("gecko", {.integrator = Integrator::rk4}, 250, 0.02);
}

TEST_CASE("kernel step: random module trees -> mj_step's") {
  Rng rng{2, Stream::user};
  Comparison comparison;
  std::size_t most_hinges = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    const RobotModel robot = random_module_robot(rng, 1 + rng.index(24));
    most_hinges = std::max(most_hinges, robot.hinges.size());
    compare_random_states(robot, {}, 10, rng, comparison);
  }
  comparison.report("module trees");
  CHECK(most_hinges > 6);
  CHECK(comparison.agrees());
  CHECK(comparison.steps > 1500);
}

TEST_CASE("kernel step: random trees of skewed hinges and boxes that touch, either depth between boxes -> mj_step's") {
  for (const BoxDepth depth : {BoxDepth::engine, BoxDepth::whole}) {
    Rng rng{3, Stream::user};
    Comparison comparison;
    for (std::size_t i = 0; i < 60; ++i) {
      compare_random_states(random_skew_robot(rng, 1 + rng.index(8)), {}, 10, rng, comparison, 0.0, depth);
    }
    comparison.report("skewed trees");
    CHECK(comparison.agrees());
    CHECK(comparison.steps > 1500);
    CHECK(comparison.touching > 10);
  }
}

TEST_CASE("kernel step: random robot, state and physics -> mj_step's, or declined") {
  CHECK(rc::check([](std::uint64_t seed, bool modules, bool euler) {
    Rng rng{seed, Stream::user};
    const RobotModel robot = modules ? random_module_robot(rng, 1 + rng.index(16)) : random_skew_robot(rng, 1 + rng.index(6));
    const Physics physics{.timestep_s = rng.uniform(1e-4, 5e-3),
                          .integrator = euler ? Integrator::semi_implicit_euler : Integrator::rk4,
                          .gravity_m_s2 = rng.uniform(0.0, 20.0)};
    Comparison comparison;
    compare_random_states(robot, physics, 1, rng, comparison);
    RC_ASSERT(comparison.agrees());
  }));
}
