// SPDX-License-Identifier: MIT
// Robots near each other and touching each other: the kernel steps them as MuJoCo does in one model.
#include <doctest/doctest.h>

#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/habitat/load/robot.hpp>

#include "kernel/reference.hpp"

using namespace trophic;
using namespace trophic::test;
using backend::mujoco::CompiledModel;
using backend::mujoco::LaneSet;

namespace {

/// Numbers of a robot in a model of several, as a state.
RobotState share_of(const RobotState& like, std::size_t share, const mjData& data) {
  RobotState state = like;
  std::copy_n(data.qpos + share * state.qpos.size(), state.qpos.size(), state.qpos.begin());
  std::copy_n(data.qvel + share * state.qvel.size(), state.qvel.size(), state.qvel.begin());
  std::copy_n(data.qacc_warmstart + share * state.warm.size(), state.warm.size(), state.warm.begin());
  return state;
}

/// Whether boxes of two robots, not of one, are in contact.
bool robots_in_contact(const mjModel& model, const mjData& data, int links) {
  for (int c = 0; c < data.ncon; ++c) {
    const int first = model.geom_bodyid[data.contact[c].geom1];
    const int second = model.geom_bodyid[data.contact[c].geom2];
    if (first != 0 && second != 0 && (first - 1) / links != (second - 1) / links) return true;
  }
  return false;
}

struct Tally {
  std::size_t stepped = 0;
  std::size_t declined = 0;
  std::size_t touching = 0;  ///< companies stepped in which robots touched
  double acceleration = 0.0;
};

/// Companies of `robots` in lanes 1, 2, ... next to a robot of another company in lane 0.
Tally compare_companies(const std::string& name, const Physics& physics, std::size_t robots, std::size_t companies,
                        BoxDepth depth = BoxDepth::engine) {
  const RobotModel robot = load_robot(name);
  const Arena arena;
  Reference one{robot, arena, physics, 0.0, depth};
  CompiledModel compiled{robot,
                         arena,
                         physics,
                         {.walls = true,
                          .collisions = backend::mujoco::Collisions::broadphase,
                          .servos = backend::mujoco::Servos::combined,
                          .box_depth = depth},
                         robots,
                         1};
  mjData& data = Reference::roomy(compiled);
  kernel::Workspace work{one.constants};
  kernel::LaneState lanes{one.constants};
  const unsigned company = ((1u << robots) - 1) << 1;
  for (std::size_t lane = 1; lane <= robots; ++lane) work.company[lane] = company;
  const auto step = kernel::fastest_step();
  Rng rng{31, Stream::user};
  Tally tally;
  for (std::size_t i = 0; i < companies; ++i) {
    std::vector<RobotState> states;
    for (std::size_t share = 0; share < robots; ++share) {
      RobotState& state = states.emplace_back(random_state(robot, arena, one, rng));
      const double apart_m = 2.0 * robot.bounding_radius_m * static_cast<double>(share) * rng.uniform(0.6, 1.1);
      const double direction_rad = rng.uniform(-3.1, 3.1);
      state.qpos[0] = apart_m * std::cos(direction_rad);
      state.qpos[1] = apart_m * std::sin(direction_rad);
      state.put(lanes, 1 + share);
      std::ranges::copy(state.qpos, data.qpos + share * state.qpos.size());
      std::ranges::copy(state.qvel, data.qvel + share * state.qvel.size());
      std::ranges::copy(state.warm, data.qacc_warmstart + share * state.warm.size());
      std::ranges::copy(state.target, data.ctrl + share * compiled.layout().controls);
    }
    states.front().put(lanes, 0);  // where another robot stands, but not of its company: it is not looked at
    const unsigned stepped = step(one.constants, lanes, work, company | 1u) & company;
    REQUIRE((stepped == 0 || stepped == company));
    mj_step(&compiled.model(), &data);
    const bool touching = robots_in_contact(compiled.model(), data, static_cast<int>(robot.links.size()));
    tally.touching += touching && stepped != 0 ? 1 : 0;
    if (stepped == 0) {
      ++tally.declined;
      RobotState after = states.back();
      after.get(lanes, robots);
      CHECK(after.qvel == states.back().qvel);
      CHECK(after.warm == states.back().warm);
      continue;
    }
    ++tally.stepped;
    for (std::size_t share = 0; share < robots; ++share) {
      RobotState after = states[share];
      after.get(lanes, 1 + share);
      const RobotState expected = share_of(after, share, data);
      tally.acceleration = std::max(tally.acceleration, relative_difference(after.warm, expected.warm, after.warm.size()));
    }
  }
  MESSAGE(robots << " of " << name << ": " << tally.stepped << " companies stepped, " << tally.declined << " left to MuJoCo, "
                 << tally.touching << " touching; acceleration " << tally.acceleration);
  return tally;
}

}  // namespace

TEST_CASE("kernel companies: robots near each other, touching or not -> the step of one model") {
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4}) {
    for (const std::size_t robots : {2U, 3U}) {
      const Tally tally = compare_companies("spider", {.integrator = integrator}, robots, 400);
      CHECK(tally.acceleration < 1e-10);
      CHECK(tally.declined < 20);
      CHECK(tally.touching > 20);
    }
  }
  CHECK(compare_companies("gecko", {}, 2, 200).acceleration < 1e-10);
}

TEST_CASE("kernel companies: robots near each other, whole depth between boxes -> the step of one model") {
  for (const std::size_t robots : {2U, 3U}) {
    const Tally tally = compare_companies("spider", {}, robots, 400, BoxDepth::whole);
    CHECK(tally.acceleration < 1e-10);
    CHECK(tally.declined < 20);
    CHECK(tally.touching > 20);
  }
  CHECK(compare_companies("gecko", {}, 2, 200, BoxDepth::whole).acceleration < 1e-10);
}

TEST_CASE("kernel companies: groups -> lanes filled with whole groups, each robot once") {
  Rng rng{32, Stream::user};
  const RobotModel robot = load_robot("spider");
  CompiledModel model{robot, Arena{}, Physics{}, reference_scene(), 1, 1};
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<std::vector<std::size_t>> groups;
    std::size_t robots = 0;
    for (std::size_t size = kernel::lane_count; size > 0; --size) {
      for (std::size_t n = rng.index(6); n > 0; --n) {
        groups.emplace_back();
        for (std::size_t i = 0; i < size; ++i) groups.back().push_back(robots++);
      }
    }
    std::vector<LaneSet> sets;
    backend::mujoco::fill_lanes(
        groups, [&](const auto&) -> CompiledModel& { return model; }, sets);
    std::vector<int> seen(robots);
    std::size_t whole_groups = 0;
    for (const LaneSet& set : sets) {
      CHECK(set.robots().size() + set.room() == kernel::lane_count);
      for (const LaneSet::Group& group : set.groups()) {
        const std::span<const std::size_t> members = set.robots(group);
        whole_groups += std::ranges::count_if(groups, [&](const auto& all) { return std::ranges::equal(all, members); }) == 1;
        for (const std::size_t member : members) ++seen[member];
      }
    }
    CHECK(whole_groups == groups.size());
    CHECK(std::ranges::all_of(seen, [](int times) { return times == 1; }));
  }
}
