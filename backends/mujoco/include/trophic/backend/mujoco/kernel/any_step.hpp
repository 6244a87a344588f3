// SPDX-License-Identifier: MIT
// One step of a batch of robots, with the results of MuJoCo 2.2.2's mj_step.
#pragma once

#include <trophic/backend/mujoco/kernel/island_search.hpp>
#include <trophic/backend/mujoco/kernel/motion.hpp>
#include <trophic/backend/mujoco/kernel/proximity.hpp>
#include <trophic/backend/mujoco/kernel/search.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// Copies the trial point as MuJoCo's qacc in the lanes of `taken`.
TROPHIC_LANES_INLINE void take_trial(const Workspace& work, const Mask& taken, LaneArray& acceleration) {
  const LinkWork& root = work.links[0];
  const Vec3 angular = transposed_times(root.rotation, root.trial.angular);
  for (std::size_t i = 0; i < 3; ++i) {
    acceleration[i] = select(taken, root.trial.linear.v[i], acceleration[i]);
    acceleration[3 + i] = select(taken, angular.v[i], acceleration[3 + i]);
  }
  for (std::size_t j = 0; j < work.hinges.size(); ++j) {
    acceleration[6 + j] = select(taken, work.hinges[j].trial, acceleration[6 + j]);
  }
}

/// Acceleration of the robots that are `valid` at the position and velocity of this stage, written to its acceleration, which is
/// also the warm start (mj_forward). Robots that the kernel cannot compute become invalid: those with a corner or link whose
/// contact depends on rounding, joint angles beyond the range of its sine, a search that does not converge, a result above
/// MuJoCo's bound for accelerations, and robots in a step set with such a robot.
TROPHIC_LANES_INLINE void forward(Batch& batch) {
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    move_links(pack.model, pack.current(), pack.work);
    for (LinkWork& link : pack.work.links) link.has_centres = false;
    pack.work.doubtful = Mask{};
  }
  find_link_contacts(batch);
  unsigned coupled = 0;
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    find_field_contacts(pack, batch.field_collider);
    limit_joints(pack.model, pack.current(), pack.work);
    find_contacts(pack.model, pack.current(), pack.work);
    pack.valid &= ~lane_bits(pack.work.doubtful);
  }
  invalidate_step_sets(batch);
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    coupled |= pack.valid & pack.coupled;
    if (const unsigned apart = pack.valid & ~pack.coupled; apart != 0) {
      pack.valid &= ~minimise(pack.model, pack.current(), pack.work, apart);
    }
  }
  if (coupled != 0) minimise_islands(batch);
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    pack.work.rows_known = true;
    const LinkWork& root = pack.work.links[0];
    Mask good = mask_of(pack.valid);
    for (int i = 0; i < 3; ++i) {
      good &= (abs(root.trial.linear[i]) < mjMAXVAL) & (abs(root.trial.angular[i]) < 0.5 * mjMAXVAL);
    }
    for (std::size_t j = 0; j < pack.work.hinges.size(); ++j) {
      good &= (abs(pack.work.hinges[j].trial) < mjMAXVAL) & (abs(pack.current().position[7 + j]) < largest_angle_rad);
    }
    pack.valid = lane_bits(good);
  }
  invalidate_step_sets(batch);
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    take_trial(pack.work, mask_of(pack.valid), pack.current().acceleration);
  }
}

/// position += time velocity in the lanes of `moved`: the quaternion is turned by the angular velocity in the root's axes
/// (mj_integratePos).
TROPHIC_LANES_INLINE void move(const LaneModel& model, const Mask& moved, double time_s, const LaneArray& velocity,
                               LaneArray& position) {
  for (std::size_t i = 0; i < 3; ++i) position[i] = select(moved, position[i] + time_s * velocity[i], position[i]);
  for (std::size_t j = 0; j < model.hinges.size(); ++j) {
    position[7 + j] = select(moved, position[7 + j] + time_s * velocity[6 + j], position[7 + j]);
  }
  const Vec3 w = {{velocity[3], velocity[4], velocity[5]}};
  const Real speed = sqrt(dot(w, w));
  Real sine, cosine;
  sine_cosine(speed * (0.5 * time_s), sine, cosine);
  const Vec3 s = w * select(speed > 1e-15, sine / speed, broadcast(0.5 * time_s));
  const Real q[4] = {position[3], position[4], position[5], position[6]};
  const Real turned[4] = {
      q[0] * cosine - q[1] * s[0] - q[2] * s[1] - q[3] * s[2], q[0] * s[0] + q[1] * cosine + q[2] * s[2] - q[3] * s[1],
      q[0] * s[1] + q[2] * cosine + q[3] * s[0] - q[1] * s[2], q[0] * s[2] + q[3] * cosine + q[1] * s[1] - q[2] * s[0]};
  for (std::size_t i = 0; i < 4; ++i) position[3 + i] = select(moved, turned[i], q[i]);
}

/// v += h a(x, v), then x += h v: semi-implicit Euler, implicit in joint damping too (mj_Euler).
TROPHIC_LANES_INLINE void finish_euler(const LaneModel& model, LaneState& state, Workspace& work, unsigned good) {
  const Mask moved = mask_of(good);
  const LaneArray* acceleration = &state.acceleration;
  if (model.shape().damped) {
    damp_joints(model, work);
    take_trial(work, moved, work.sum.acceleration);
    acceleration = &work.sum.acceleration;
  }
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    state.velocity[i] = select(moved, state.velocity[i] + model.shape().timestep_s * (*acceleration)[i], state.velocity[i]);
  }
  move(model, moved, model.shape().timestep_s, state.velocity, state.position);
}

/// x += h sum of weighted velocities, v += h sum of weighted accelerations, warm start of the last stage.
TROPHIC_LANES_INLINE void finish_runge_kutta(const LaneModel& model, LaneState& state, const Workspace& work, unsigned good) {
  const Mask moved = mask_of(good);
  move(model, moved, model.shape().timestep_s, work.sum.velocity, state.position);
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    state.velocity[i] = select(moved, state.velocity[i] + model.shape().timestep_s * work.sum.acceleration[i], state.velocity[i]);
    state.acceleration[i] = select(moved, work.stage.acceleration[i], state.acceleration[i]);
  }
}

/// The classical Runge-Kutta method of order 4 (mj_RungeKutta) evaluates the acceleration at x, x + h/2 v1, x + h/2 v2, x + h v3,
/// and sums with weights 1/6, 1/3, 1/3, 1/6.
TROPHIC_LANES_INLINE void begin_runge_kutta(Pack& pack) {
  LaneState& sum = pack.work.sum;
  pack.work.stage = pack.state;
  normalize_quaternion(pack.state.position);
  for (std::size_t i = 0; i < sum.velocity.size(); ++i) sum.velocity[i] = sum.acceleration[i] = Real{};
}

/// Adds stage `s` to the sums and goes to the next stage.
TROPHIC_LANES_INLINE void next_stage(Pack& pack, std::size_t s) {
  constexpr double ahead[4] = {0.5, 0.5, 1.0, 0.0};
  constexpr double weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  const LaneState& state = pack.state;
  LaneState& stage = pack.work.stage;
  LaneState& sum = pack.work.sum;
  const std::size_t speeds = state.velocity.size();
  for (std::size_t i = 0; i < speeds; ++i) {
    sum.velocity[i] += weight[s] * stage.velocity[i];
    sum.acceleration[i] += weight[s] * stage.acceleration[i];
  }
  if (s == 3) return;
  const double step_s = ahead[s] * pack.model.shape().timestep_s;
  stage.position = state.position;
  move(pack.model, mask_of(pack.valid), step_s, stage.velocity, stage.position);
  for (std::size_t i = 0; i < speeds; ++i) stage.velocity[i] = state.velocity[i] + step_s * stage.acceleration[i];
}

/// One step of all robots of a batch. Afterwards those that took it are `valid`; the others keep their state.
TROPHIC_LANES_INLINE void any_step(Batch& batch) {
  const bool euler = !batch.packs[0]->model.shape().runge_kutta;
  batch.step_sets.reset(batch.pack_count * lane_count);
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    batch.packs[t]->valid = batch.packs[t]->lanes;
    if (!euler) begin_runge_kutta(*batch.packs[t]);
  }
  // A robot that fails in one stage is absent in the next, so its neighbours must fail too.
  if (!euler) {
    for (const auto& [a, b] : batch.neighbours) batch.step_sets.unite(a, b);
  }
  const std::size_t stages = euler ? 1 : 4;
  for (std::size_t s = 0; s < stages; ++s) {
    batch.island_sets.reset(batch.pack_count * lane_count);
    forward(batch);
    for (std::size_t t = 0; !euler && t < batch.pack_count; ++t) next_stage(*batch.packs[t], s);
  }
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    if (euler) {
      finish_euler(pack.model, pack.state, pack.work, pack.valid);
    } else {
      finish_runge_kutta(pack.model, pack.state, pack.work, pack.valid);
    }
  }
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
