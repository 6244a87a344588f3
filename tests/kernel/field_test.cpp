// SPDX-License-Identifier: MIT
// Robots on a height field or with parallel edges, where rounding decides which contacts MuJoCo finds.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

#include "kernel/reference.hpp"

using namespace trophic;
using namespace trophic::test;

namespace {

kernel::PlacedBox box_of(const Reference& reference, int geom) {
  kernel::PlacedBox box;
  const mjtNum* const turn = reference.data.geom_xmat + 9 * geom;
  std::copy_n(reference.data.geom_xpos + 3 * geom, 3, box.centre_m.begin());
  std::copy_n(reference.model.geom_size + 3 * geom, 3, box.half_m.begin());
  for (std::size_t k = 0; k < 3; ++k) box.axis[k] = {turn[k], turn[3 + k], turn[6 + k]};
  return box;
}

/// The same numbers, each but for rounding.
RobotState nudged(const RobotState& state, Rng& rng) {
  RobotState other = state;
  for (double& x : other.qpos) x *= 1.0 + rng.uniform(-2.3e-16, 2.3e-16);
  return other;
}

/// How much steps from random states differ from mj_step's.
struct Differences {
  std::vector<double> of_kernel;
  std::vector<double> of_rounding;  ///< mj_step's own, from states that differ by rounding
  std::size_t contacts = 0;
  std::size_t declined = 0;

  static double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
  }
  static std::ptrdiff_t jumps(const std::vector<double>& values) {
    return std::ranges::count_if(values, [](double value) { return value > 1e-9; });
  }
};

Differences compare_random_states(const RobotModel& robot, const Arena& arena, const Physics& physics, std::size_t groups) {
  Reference reference{robot, arena, physics};
  mjModel& model = reference.model;
  for (int pair = 0; pair < model.npair; ++pair) {
    // as in the kernel, links do not touch that overlap by rounding only
    if (model.geom_bodyid[model.pair_geom1[pair]] != 0) model.pair_gap[pair] = 1e-14;
  }
  OnePack lanes{reference.constants};
  Rng rng{4, Stream::user};
  Differences found;
  const auto accelerations = [&](const RobotState& from) {
    from.put(reference.data);
    reference.step();
    return std::vector<double>(reference.data.qacc_warmstart, reference.data.qacc_warmstart + from.warm.size());
  };
  for (std::size_t group = 0; group < groups; ++group) {
    std::vector<RobotState> states;
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
      states.push_back(random_state(robot, arena, reference, rng));
      states.back().put(lanes.pack, lane);
    }
    const unsigned stepped = lanes.step(0xfu);
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
      if ((stepped & (1u << lane)) == 0) {
        ++found.declined;
        continue;
      }
      RobotState after = states[lane];
      after.get(lanes.pack, lane);
      const std::vector<double> expected = accelerations(states[lane]);
      found.contacts += static_cast<std::size_t>(reference.data.ncon);
      found.of_kernel.push_back(relative_difference(after.warm, expected, expected.size()));
      found.of_rounding.push_back(relative_difference(accelerations(nudged(states[lane], rng)), expected, expected.size()));
    }
  }
  return found;
}

void check_robot_on_field(const std::string& name, const Physics& physics) {
  constexpr std::size_t groups = 500;
  const Differences found = compare_random_states(load_robot(name), load_arena("height_field"), physics, groups);
  const auto steps = static_cast<std::ptrdiff_t>(found.of_kernel.size());
  MESSAGE(name << ": " << steps << " steps, " << found.contacts << " contacts, " << found.declined
               << " left to MuJoCo; median difference of acceleration " << Differences::median(found.of_kernel)
               << ", of MuJoCo's own from a state one rounding away " << Differences::median(found.of_rounding)
               << "; steps that differ by more than 1e-9: " << Differences::jumps(found.of_kernel) << " and "
               << Differences::jumps(found.of_rounding));
  CHECK(Differences::median(found.of_kernel) < 1e-13);
  CHECK(Differences::jumps(found.of_kernel) <= Differences::jumps(found.of_rounding) + 5);
  // Legs with parallel edges make more steps jump, and so does MuJoCo 3, whose iteration amplifies rounding.
  CHECK(Differences::jumps(found.of_kernel) < steps / 10);
  CHECK(steps > 4 * static_cast<std::ptrdiff_t>(groups) * 3 / 4);
  CHECK(found.contacts > found.of_kernel.size());
}

}  // namespace

TEST_CASE("kernel height field: contacts of a robot's boxes -> those of mj_collision") {
  const Arena arena = load_arena("height_field");
  std::size_t total = 0;
  for (const std::string name : {"spider_released", "gecko"}) {
    const RobotModel robot = load_robot(name);
    Reference reference{robot, arena, {}};
    const mjModel& model = reference.model;
    kernel::FieldCollider collider{reference.constants->field.value()};
    Rng rng{5, Stream::user};
    for (int trial = 0; trial < 500; ++trial) {
      random_state(robot, arena, reference, rng).put(reference.data);
      mj_fwdPosition(&model, &reference.data);
      std::vector<mjContact> expected;
      for (int c = 0; c < reference.data.ncon; ++c) {
        const mjContact& contact = reference.data.contact[c];
        if (model.geom_type[contact.geom1] == mjGEOM_HFIELD && contact.dist < 0.0) expected.push_back(contact);
      }
      std::ranges::stable_sort(expected, {}, &mjContact::geom2);
      std::size_t next = 0;
      for (int geom = 0; geom < model.ngeom; ++geom) {
        if (model.geom_type[geom] != mjGEOM_BOX) continue;
        const kernel::PlacedBox box = box_of(reference, geom);
        std::size_t contacts = 0;
        const auto compare = [&](const kernel::BoxContact& contact) {
          ++contacts;
          REQUIRE(next < expected.size());
          const mjContact& other = expected[next++];
          CHECK(other.geom2 == geom);
          CHECK(contact.depth_m == other.dist);
          for (std::size_t i = 0; i < 3; ++i) {
            CHECK(contact.point_m[i] == other.pos[i]);
            for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(contact.frame[k][i] - other.frame[3 * k + i]) < 1e-15);
          }
        };
        static_cast<void>(collider.collide(box, {}, compare));
        const double reach_m = model.geom_rbound[geom];
        if (contacts > 0) CHECK(box.centre_m[2] - reach_m < collider.highest_m(box.centre_m[0], box.centre_m[1], reach_m));
      }
      CHECK(next == expected.size());
      total += next;
    }
  }
  CHECK(total > 1500);
}

TEST_CASE("kernel height field: highest node near a point -> bounds the ground there") {
  const Arena arena = load_arena("height_field");
  const RobotModel robot = load_robot("gecko");
  const Reference reference{robot, arena, {}};
  const kernel::FieldCollider collider{reference.constants->field.value()};
  CHECK(collider.highest_m(0.0, 0.0, 0.1) == 0.0);
  CHECK(collider.highest_m(9.2, 0.0, 0.1) == 0.0);  // the flat floor ends at 9.333 m
  CHECK(collider.highest_m(9.3, 0.0, 0.1) == doctest::Approx(10.0));
  CHECK(collider.highest_m(0.0, -11.0, 0.1) == doctest::Approx(10.0));
  CHECK(collider.highest_m(50.0, 0.0, 0.1) == doctest::Approx(10.0));  // beyond the edge: that of the edge
}

TEST_CASE("kernel height field: touching box along the world's axes -> left to MuJoCo") {
  const Arena arena = load_arena("height_field");
  const RobotModel robot = load_robot("gecko");
  Reference reference{robot, arena, {}};
  OnePack lanes{reference.constants};
  RobotState state = resting(robot);
  state.qpos[2] -= 0.001;
  state.put(lanes.pack, 0);
  CHECK(lanes.step(1u) == 0);
  state.qpos[2] += 0.1;
  state.put(lanes.pack, 0);
  CHECK(lanes.step(1u) == 1);
}

TEST_CASE("kernel height field: one Runge-Kutta step -> mj_step's to within the effect of rounding") {
  const Physics physics{.timestep_s = 0.012, .integrator = Integrator::rk4};
  check_robot_on_field("spider_released", physics);
  check_robot_on_field("gecko", physics);
}

TEST_CASE("kernel height field: one Euler step -> mj_step's to within the effect of rounding") {
  check_robot_on_field("spider_released", {});
  check_robot_on_field("gecko", {});
}

TEST_CASE("kernel edges: legs side by side -> mj_step's but for rounding" * doctest::skip(backend::mujoco::is_mujoco_3)) {
  for (const int turn : {0, 1}) {  // beside each other, and into each other
    body::Design design;
    std::size_t trunk = 0;
    for (const body::Face next : {body::Face::back, body::Face::front, body::Face::front}) {
      for (const body::Face side : {body::Face::left, body::Face::right}) {
        const std::size_t hip = design.modules.attach(trunk, side, body::ModuleType::hinge, turn);
        design.modules.attach(hip, body::Face::front, body::ModuleType::brick, 0);
      }
      trunk = design.modules.attach(trunk, next, body::ModuleType::brick, 0);
    }
    const Differences found = compare_random_states(body::build(design), {}, {}, 250);
    const auto jumps = Differences::jumps(found.of_kernel);
    MESSAGE(jumps << " jumps, MuJoCo's own " << Differences::jumps(found.of_rounding) << ", declined " << found.declined);
    CHECK(found.declined < 5);
    CHECK(jumps <= Differences::jumps(found.of_rounding) * 3 / 2);
    CHECK((turn == 0) == (jumps == 0));
  }
}
