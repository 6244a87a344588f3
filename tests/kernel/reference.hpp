// SPDX-License-Identifier: MIT
// One robot in MuJoCo, and random states to compare it with the kernel in.
#pragma once

#include <mujoco/mujoco.h>

#include <algorithm>
#include <trophic/backend/contract.hpp>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/kernel/batch.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::test {

namespace kernel = backend::kernel;
using backend::mujoco::BoxDepth;

/// As the backend models a single robot.
[[nodiscard]] inline backend::mujoco::Scene reference_scene(BoxDepth depth = BoxDepth::engine) {
  using namespace backend::mujoco;
  return {.walls = true, .collisions = Collisions::pairs, .servos = Servos::combined, .box_depth = depth};
}

/// One robot in MuJoCo, and the kernel's constants read from it.
struct Reference {
  backend::mujoco::CompiledModel compiled;
  mjModel& model;
  mjData& data;
  std::shared_ptr<const kernel::KernelModel> constants;

  /// `joint_damping` N m s is given to all hinges.
  Reference(const RobotModel& robot, const Arena& arena, const Physics& physics, double joint_damping = 0.0,
            BoxDepth depth = BoxDepth::engine)
      : compiled{robot, arena, physics, reference_scene(depth), 1, 1},
        model{const_cast<mjModel&>(compiled.model())},
        data{roomy(compiled)} {
    for (int dof = 6; dof < model.nv; ++dof) model.dof_damping[dof] = joint_damping;
    constants = std::make_shared<const kernel::KernelModel>(kernel::read_model(model).value());
  }

  /// Room for every corner of the robot in every plane.
  [[nodiscard]] static mjData& roomy(backend::mujoco::CompiledModel& compiled) {
    for (int i = 0; i < 2; ++i) compiled.grow();
    return compiled.data(0);
  }

  /// One mj_step without any warning.
  void step() {
    mj_step(&model, &data);
    for (const mjWarningStat& warning : data.warning) {
      if (warning.number != 0) throw std::runtime_error{"MuJoCo warned"};
    }
  }
};

/// A robot's state as MuJoCo lays it out.
struct RobotState {
  std::vector<double> qpos, qvel, warm, target;

  void put(mjData& data) const {
    std::ranges::copy(qpos, data.qpos);
    std::ranges::copy(qvel, data.qvel);
    std::ranges::copy(warm, data.qacc_warmstart);
    std::ranges::copy(target, data.ctrl);
  }
  void get(const mjData& data) {
    std::copy_n(data.qpos, qpos.size(), qpos.begin());
    std::copy_n(data.qvel, qvel.size(), qvel.begin());
    std::copy_n(data.qacc_warmstart, warm.size(), warm.begin());
  }
  void put(kernel::Pack& pack, std::size_t lane) const {
    std::vector<double> numbers = qpos;
    numbers.insert(numbers.end(), qvel.begin(), qvel.end());
    numbers.insert(numbers.end(), warm.begin(), warm.end());
    pack.state.load(pack.model.body(lane), lane, numbers, target);
  }
  void get(const kernel::Pack& pack, std::size_t lane) {
    std::vector<double> numbers(qpos.size() + qvel.size() + warm.size());
    pack.state.store(lane, numbers);
    const auto speeds = numbers.begin() + static_cast<std::ptrdiff_t>(qpos.size());
    const auto accelerations = speeds + static_cast<std::ptrdiff_t>(qvel.size());
    qpos.assign(numbers.begin(), speeds);
    qvel.assign(speeds, accelerations);
    warm.assign(accelerations, numbers.end());
  }
};

/// A batch of one pack of robots that cannot touch each other.
struct OnePack {
  kernel::Batch batch;
  kernel::Pack& pack;

  explicit OnePack(const std::shared_ptr<const kernel::KernelModel>& body)
      : batch{body->box_depth}, pack{batch.add_pack({&body, 1})} {
    for (std::size_t lane = 0; lane < kernel::lane_count; ++lane) batch.order.push_back({0, lane});
  }
  /// Steps the robots in `lanes`; returns those that took the step.
  [[nodiscard]] unsigned step(unsigned lanes, kernel::StepFunction function = kernel::fastest_step()) {
    pack.lanes = lanes;
    function(batch);
    return pack.valid;
  }
};

/// At rest on the floor, angles 0.
[[nodiscard]] inline RobotState resting(const RobotModel& robot) {
  RobotState state;
  state.qpos.assign(robot.hinges.size() + 7, 0.0);
  state.qpos[2] = robot.rest_height_m;
  state.qpos[3] = 1.0;
  state.qvel.assign(robot.hinges.size() + 6, 0.0);
  state.warm = state.qvel;
  state.target.assign(robot.hinges.size(), 0.0);
  return state;
}

/// Height of the ground at a point: 0, or the bilinear height of a field, which its triangles are never far from.
[[nodiscard]] inline double ground_m(const Arena& arena, double x_m, double y_m) {
  if (!arena.height_field) return 0.0;
  const HeightField& field = *arena.height_field;
  const double spacing_m = 2.0 * field.half_extent_m / static_cast<double>(field.nodes - 1);
  const double x = (x_m + field.half_extent_m) / spacing_m;
  const double y = (y_m + field.half_extent_m) / spacing_m;
  const auto ix = static_cast<std::size_t>(x);
  const auto iy = static_cast<std::size_t>(y);
  const auto at = [&](std::size_t i, std::size_t j) { return field.height_m.at(j * field.nodes + i); };
  const double u = x - static_cast<double>(ix);
  const double v = y - static_cast<double>(iy);
  return (1 - v) * ((1 - u) * at(ix, iy) + u * at(ix + 1, iy)) + v * ((1 - u) * at(ix, iy + 1) + u * at(ix + 1, iy + 1));
}

/// Any pose, most of them near the ground, some at a wall or where the ground begins to rise; angles up to beyond the limits;
/// fast and slow.
[[nodiscard]] inline RobotState random_state(const RobotModel& robot, const Arena& arena, Reference& reference, Rng& rng) {
  const mjModel& model = reference.model;
  mjData& scratch = reference.data;
  RobotState state = resting(robot);
  const double tilt = rng.chance(0.5) ? 0.2 : 2.0;
  Eigen::Quaterniond turn =
      Eigen::AngleAxisd(rng.uniform(-3.1, 3.1), Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(tilt * rng.normal(0.0, 1.0), Eigen::Vector3d(rng.normal(0, 1), rng.normal(0, 1), 0.1).normalized());
  state.qpos[3] = turn.w(), state.qpos[4] = turn.x(), state.qpos[5] = turn.y(), state.qpos[6] = turn.z();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    state.qpos[axis] = rng.uniform(-5.0, 5.0);
    if (rng.chance(0.15)) state.qpos[axis] = (rng.chance(0.5) ? 1 : -1) * (arena.half_side_m - rng.uniform(0.02, 0.2));
  }
  const double bend = rng.chance(0.8) ? 0.8 : 1.15;
  for (std::size_t j = 0; j < robot.hinges.size(); ++j) {
    state.qpos[7 + j] = rng.uniform(-bend, bend);
    state.target[j] = rng.uniform(-1.3, 1.3);
  }
  const double speed = rng.chance(0.5) ? 0.1 : 2.0;
  for (double& v : state.qvel) v = speed * rng.normal(0.0, 1.0);
  const double warm = rng.chance(0.5) ? 0.0 : 30.0;
  for (double& a : state.warm) a = warm * rng.normal(0.0, 1.0);
  // Lowest corner a few millimetres in or above the floor.
  state.put(scratch);
  mj_kinematics(&model, &scratch);
  double lowest_m = 1e9;
  for (int g = 0; g < model.ngeom; ++g) {
    if (model.geom_type[g] != mjGEOM_BOX) continue;
    double reach_m = 0.0;
    for (int k = 0; k < 3; ++k) reach_m += model.geom_size[3 * g + k] * std::abs(scratch.geom_xmat[9 * g + 6 + k]);
    lowest_m = std::min(lowest_m, scratch.geom_xpos[3 * g + 2] - reach_m);
  }
  state.qpos[2] += rng.uniform(-0.004, 0.001) - lowest_m + ground_m(arena, state.qpos[0], state.qpos[1]);
  return state;
}

/// Whether boxes of two links touch that have edges parallel to edges or faces, so that rounding decides which contacts they
/// have.
[[nodiscard]] inline bool has_ties(const mjModel& model, const mjData& data) {
  const auto is_tied = [&](const mjContact& contact) {
    if (model.geom_bodyid[contact.geom1] == 0) return false;
    mjtNum cosines[9];
    mju_mulMatTMat(cosines, data.geom_xmat + 9 * contact.geom1, data.geom_xmat + 9 * contact.geom2, 3, 3, 3);
    return std::ranges::any_of(cosines, [](mjtNum cosine) { return std::abs(std::abs(cosine) - 0.5) > 0.5 - 1e-11; });
  };
  return std::any_of(data.contact, data.contact + data.ncon, is_tied);
}

/// Largest |a_i - b_i|, divided by the largest |b_i| (at least 1).
template <class Left, class Right>
[[nodiscard]] double relative_difference(const Left& a, const Right& b, std::size_t n) {
  double difference = 0.0;
  double scale = 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    scale = std::max(scale, std::abs(b[i]));
  }
  return std::isnan(difference) ? 1e300 : difference / scale;
}

}  // namespace trophic::test
