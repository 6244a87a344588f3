// SPDX-License-Identifier: MIT
// Robots near each other and touching each other: the kernel steps them as MuJoCo does in one model.
#include <doctest/doctest.h>

#include <numeric>
#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/habitat/load/robot.hpp>

#include "kernel/random_robot.hpp"
#include "kernel/reference.hpp"

using namespace trophic;
using namespace trophic::test;
using backend::Disc;
using backend::mujoco::BatchPlan;
using backend::mujoco::BatchPlanner;
using backend::mujoco::CompiledModel;
using backend::mujoco::Share;

namespace {

/// Numbers of a robot in a model of several, as a state.
RobotState share_of(const RobotState& like, const Share& share, const mjData& data) {
  RobotState state = like;
  std::copy_n(data.qpos + share.position, state.qpos.size(), state.qpos.begin());
  std::copy_n(data.qvel + share.velocity, state.qvel.size(), state.qvel.begin());
  std::copy_n(data.qacc_warmstart + share.velocity, state.warm.size(), state.warm.begin());
  return state;
}

/// Whether boxes of two robots, not of one, are in contact.
bool robots_in_contact(const mjModel& model, const mjData& data) {
  for (int c = 0; c < data.ncon; ++c) {
    const int first = model.geom_bodyid[data.contact[c].geom1];
    const int second = model.geom_bodyid[data.contact[c].geom2];
    if (first != 0 && second != 0 && model.body_rootid[first] != model.body_rootid[second]) return true;
  }
  return false;
}

struct Tally {
  std::size_t stepped = 0;  ///< robots
  std::size_t declined = 0;
  std::size_t touching = 0;  ///< groups stepped as a whole in which robots touched
  double acceleration = 0.0;

  [[nodiscard]] bool agrees(std::size_t least_touching = 20) const {
    return acceleration < 1e-10 && declined < stepped / 10 && touching > least_touching;
  }
};

/// Groups of robots of these bodies, the last with a robot of another group in the lane next to its own.
Tally compare_batches(const std::string& name, const std::vector<RobotModel>& bodies, const Physics& physics, std::size_t trials,
                      BoxDepth depth = BoxDepth::engine) {
  const Arena arena;
  const std::size_t robots = bodies.size();
  std::vector<std::unique_ptr<Reference>> alone;
  std::vector<const RobotModel*> models;
  for (const RobotModel& body : bodies) {
    alone.push_back(std::make_unique<Reference>(body, arena, physics, 0.0, depth));
    models.push_back(&body);
  }
  CompiledModel compiled{models, arena, physics, {.servos = backend::mujoco::Servos::combined, .box_depth = depth}, 1};
  mjData& data = Reference::roomy(compiled);
  const auto shape_of = [&](std::size_t robot) {
    const kernel::KernelModel& own = *alone[robot % robots]->constants;
    const auto same = [&](const auto& other) { return kernel::same_shape(own, *other->constants); };
    return static_cast<std::size_t>(std::ranges::find_if(alone, same) - alone.begin());
  };
  std::vector<std::vector<std::size_t>> groups{std::vector<std::size_t>(robots), {2 * robots - 1}};
  std::iota(groups[0].begin(), groups[0].end(), std::size_t{0});
  BatchPlanner planner;
  const std::vector<Disc> discs(2 * robots, Disc{0.0, 0.0, 1.0});
  const BatchPlan plan = planner.plan(groups, discs, shape_of).front();
  kernel::Batch batch{depth};
  for (const BatchPlan::Pack& planned : plan.packs) {
    std::vector<std::shared_ptr<const kernel::KernelModel>> lanes;
    for (std::size_t lane = 0; lane < planned.used; ++lane) lanes.push_back(alone[planned.robots[lane] % robots]->constants);
    batch.add_pack(lanes).lanes = (1u << planned.used) - 1;
  }
  batch.order = plan.order;
  batch.neighbours = plan.neighbours;

  const auto step = kernel::fastest_step();
  Rng rng{31, Stream::user};
  Tally tally;
  for (std::size_t i = 0; i < trials; ++i) {
    std::vector<RobotState> states;
    double from_centre_m = 0.0;
    for (std::size_t robot = 0; robot < robots; ++robot) {
      RobotState& state = states.emplace_back(random_state(bodies[robot], arena, *alone[robot], rng));
      const double direction_rad = rng.uniform(-3.1, 3.1);
      state.qpos[0] = from_centre_m * std::cos(direction_rad);
      state.qpos[1] = from_centre_m * std::sin(direction_rad);
      from_centre_m = 2.0 * bodies[robot].bounding_radius_m * std::sqrt(static_cast<double>(robot + 1)) * rng.uniform(0.6, 1.1);
      const Share& share = compiled.shares()[robot];
      std::ranges::copy(state.qpos, data.qpos + share.position);
      std::ranges::copy(state.qvel, data.qvel + share.velocity);
      std::ranges::copy(state.warm, data.qacc_warmstart + share.velocity);
      std::ranges::copy(state.target, data.ctrl + share.control);
    }
    // The robot of another group stands in the last one, which does not look at it.
    for (const kernel::LaneIndex& at : batch.order) states[plan.robot(at) % robots].put(batch.pack(at), at.lane);
    for (std::size_t t = 0; t < batch.pack_count; ++t) batch.packs[t]->work.forget_rows();
    step(batch);
    mj_step(&compiled.model(), &data);
    const bool tied = has_ties(compiled.model(), data);
    bool whole = !tied;
    for (const kernel::LaneIndex& at : batch.order) {
      const std::size_t robot = plan.robot(at);
      if (robot >= robots) continue;
      RobotState after = states[robot];
      after.get(batch.pack(at), at.lane);
      if (!batch.pack(at).is_valid(at.lane)) {
        whole = false;
        ++tally.declined;
        CHECK(after.qvel == states[robot].qvel);
        CHECK(after.warm == states[robot].warm);
        continue;
      }
      ++tally.stepped;
      if (tied) continue;
      const RobotState expected = share_of(after, compiled.shares()[robot], data);
      tally.acceleration = std::max(tally.acceleration, relative_difference(after.warm, expected.warm, after.warm.size()));
    }
    tally.touching += whole && robots_in_contact(compiled.model(), data) ? 1U : 0U;
  }
  MESSAGE(name << ": " << tally.stepped << " robots stepped, " << tally.declined << " left to MuJoCo, " << tally.touching
               << " groups touching; acceleration " << tally.acceleration);
  return tally;
}

/// The same tree with other lengths, masses, servos and ranges.
RobotModel varied(RobotModel robot, Rng& rng) {
  for (Link& link : robot.links) {
    const double heavier = rng.uniform(0.7, 1.4);
    link.mass_kg *= heavier;
    link.inertia_kgm2 *= heavier;
    link.offset_m *= rng.uniform(0.9, 1.1);
    for (Box& box : link.boxes) box.half_extents_m *= rng.uniform(0.8, 1.1);
  }
  for (Hinge& hinge : robot.hinges) {
    hinge.range_rad *= rng.uniform(0.8, 1.0);
    hinge.servo.position_gain *= rng.uniform(0.5, 2.0);
  }
  robot.bounding_radius_m *= 1.3;
  return robot;
}

std::vector<RobotModel> several(const std::string& name, std::size_t robots) {
  return std::vector<RobotModel>(robots, load_robot(name));
}

}  // namespace

TEST_CASE("kernel batches: robots near each other, touching or not, either depth between boxes -> the step of one model") {
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4}) {
    for (const std::size_t robots : {2U, 3U}) {
      CHECK(compare_batches("spiders", several("spider", robots), {.integrator = integrator}, 400).agrees());
    }
    CHECK(compare_batches("seven spiders", several("spider", 7), {.integrator = integrator}, 60).agrees());
  }
  CHECK(compare_batches("geckos", several("gecko", 2), {}, 200).agrees(0));
  for (const std::size_t robots : {2U, 3U}) {
    CHECK(compare_batches("spiders", several("spider", robots), {}, 400, BoxDepth::whole).agrees());
  }
  CHECK(compare_batches("geckos", several("gecko", 2), {}, 200, BoxDepth::whole).agrees(0));
}

TEST_CASE("kernel batches: robots of several bodies near each other -> the step of one model") {
  Rng rng{33, Stream::user};
  const RobotModel spider = load_robot("spider");
  const RobotModel gecko = load_robot("gecko");
  RobotModel slippery = gecko;
  slippery.friction = 0.2;
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4}) {
    const Physics physics{.integrator = integrator};
    CHECK(compare_batches("spider, gecko", {spider, gecko}, physics, 300).agrees());
    CHECK(compare_batches("geckos of two frictions, spiders", {gecko, spider, slippery, spider, gecko, spider}, physics, 60)
              .agrees());
  }
  const std::vector<RobotModel> any = {random_module_robot(rng, 9), random_module_robot(rng, 14), random_module_robot(rng, 14)};
  CHECK(compare_batches("random modules", any, {}, 300).agrees());
}

TEST_CASE("kernel batches: bodies of one tree with other numbers in one pack -> the step of one model") {
  Rng rng{35, Stream::user};
  for (const std::string name : {"spider", "gecko"}) {
    std::vector<RobotModel> bodies;
    for (int i = 0; i < 4; ++i) bodies.push_back(varied(load_robot(name), rng));
    CHECK(compare_batches("varied " + name, bodies, {}, 150).agrees(name == "spider" ? 20 : 0));
    CHECK(compare_batches("varied " + name, bodies, {.integrator = Integrator::rk4}, 50).agrees(name == "spider" ? 5 : 0));
  }
}

TEST_CASE("kernel batches: robots of one body or of four in a pack -> the same bytes") {
  Rng rng{36, Stream::user};
  std::vector<std::unique_ptr<Reference>> alone;
  std::vector<std::shared_ptr<const kernel::KernelModel>> constants;
  std::vector<RobotModel> bodies;
  for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
    bodies.push_back(varied(load_robot("spider"), rng));
    alone.push_back(std::make_unique<Reference>(bodies.back(), Arena{}, Physics{}));
    constants.push_back(alone.back()->constants);
    CHECK(kernel::same_shape(*constants.front(), *constants.back()));
  }
  kernel::Batch mixed{BoxDepth::engine};
  for (int trial = 0; trial < 50; ++trial) {
    mixed.clear();
    kernel::Pack& pack = mixed.add_pack(constants);
    pack.lanes = kernel::all_lanes;
    std::vector<RobotState> states;
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
      states.push_back(random_state(bodies[lane], Arena{}, *alone[lane], rng));
      states.back().put(pack, lane);
      mixed.order.push_back({0, lane});
    }
    kernel::fastest_step()(mixed);
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) {
      OnePack own{constants[lane]};
      states[lane].put(own.pack, lane);
      const unsigned valid = own.step(1u << lane);
      CHECK(valid == (pack.valid & (1u << lane)));
      RobotState apart = states[lane];
      RobotState together = states[lane];
      apart.get(own.pack, lane);
      together.get(pack, lane);
      CHECK(apart.qpos == together.qpos);
      CHECK(apart.warm == together.warm);
    }
    std::rotate(constants.begin(), constants.begin() + 1, constants.end());
    std::rotate(alone.begin(), alone.begin() + 1, alone.end());
    std::rotate(bodies.begin(), bodies.begin() + 1, bodies.end());
  }
  Reference other{load_robot("gecko"), Arena{}, Physics{}};
  CHECK(!kernel::same_shape(*other.constants, *constants.front()));
}

TEST_CASE("kernel batches: crowd in another order of lanes -> the same bytes") {
  const RobotModel robot = load_robot("spider");
  Reference reference{robot, Arena{}, {}};
  Rng rng{34, Stream::user};
  constexpr std::size_t robots = 11;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<RobotState> states;
    for (std::size_t i = 0; i < robots; ++i) {
      states.push_back(random_state(robot, Arena{}, reference, rng));
      for (std::size_t k = 0; k < 2; ++k) states.back().qpos[k] = 0.5 * rng.uniform(-1.0, 1.0);
    }
    std::vector<std::size_t> slots(robots);
    std::iota(slots.begin(), slots.end(), std::size_t{0});
    std::vector<std::vector<RobotState>> results;
    std::vector<unsigned> valid;
    for (int order = 0; order < 2; ++order) {
      kernel::Batch batch{BoxDepth::engine};
      for (std::size_t t = 0; t < 3; ++t) batch.add_pack({&reference.constants, 1});
      for (std::size_t i = 0; i < robots; ++i) {
        const kernel::LaneIndex at{slots[i] / kernel::lane_count, slots[i] % kernel::lane_count};
        for (const kernel::LaneIndex& other : batch.order) batch.neighbours.push_back({other, at});
        batch.order.push_back(at);
        batch.pack(at).lanes |= 1u << at.lane;
        states[i].put(batch.pack(at), at.lane);
      }
      kernel::fastest_step()(batch);
      results.push_back(states);
      valid.push_back(0);
      for (std::size_t i = 0; i < robots; ++i) {
        const kernel::LaneIndex& at = batch.order[i];
        results.back()[i].get(batch.pack(at), at.lane);
        valid.back() |= batch.pack(at).is_valid(at.lane) ? 1u << i : 0u;
      }
      rng.shuffle(std::span{slots});
    }
    CHECK(valid[0] == valid[1]);
    for (std::size_t i = 0; i < robots; ++i) {
      CHECK(results[0][i].qpos == results[1][i].qpos);
      CHECK(results[0][i].warm == results[1][i].warm);
    }
  }
}

TEST_CASE("kernel batches: groups -> batches with whole groups, each robot once in a pack of its shape") {
  Rng rng{32, Stream::user};
  for (std::size_t trial = 0; trial < 100; ++trial) {
    BatchPlanner planner{1 + trial % 16};
    std::vector<std::vector<std::size_t>> groups;
    std::size_t robots = 0;
    for (std::size_t size = 9; size > 0; --size) {
      for (std::size_t n = rng.index(size == 1 ? 12 : 4); n > 0; --n) {
        groups.emplace_back();
        for (std::size_t i = 0; i < size; ++i) groups.back().push_back(robots++);
      }
    }
    const std::size_t shapes = 1 + rng.index(3);
    const auto shape_of = [&](std::size_t robot) { return (robot * 7 + robot / 5) % shapes; };
    const std::vector<Disc> discs(robots, Disc{0.0, 0.0, 1.0});
    std::vector<std::size_t> batch_of(robots);
    std::vector<int> seen(robots);
    std::size_t batches = 0;
    std::size_t half_empty = 0;  // packs of robots that cannot touch others
    for (const BatchPlan& plan : planner.plan(groups, discs, shape_of)) {
      ++batches;
      const bool only_lone = plan.neighbours.empty();
      half_empty += only_lone ? static_cast<std::size_t>(std::ranges::count_if(plan.packs, &BatchPlan::Pack::room)) : 0;
      for (const kernel::LaneIndex& at : plan.order) {
        ++seen[plan.robot(at)];
        batch_of[plan.robot(at)] = batches;
        CHECK(at.lane < plan.packs[at.pack].used);
        CHECK(shape_of(plan.robot(at)) == plan.packs[at.pack].shape);
      }
      for (const auto& [a, b] : plan.neighbours) CHECK(plan.robot(a) < plan.robot(b));
    }
    CHECK(std::ranges::all_of(seen, [](int times) { return times == 1; }));
    for (std::size_t i = 0; i < groups.size(); ++i) {
      CHECK(std::ranges::all_of(groups[i], [&](std::size_t robot) { return batch_of[robot] == batch_of[groups[i].front()]; }));
      if (i <= trial % 16 && groups[i].size() > 1) CHECK(batch_of[groups[i].front()] == i + 1);
    }
    CHECK(half_empty <= shapes);
  }
}
