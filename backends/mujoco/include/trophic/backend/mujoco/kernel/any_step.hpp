// SPDX-License-Identifier: MIT
// One step of four robots, as MuJoCo 2.2.2's mj_step computes it.
#pragma once

#include <trophic/backend/mujoco/kernel/minimise_coupled.hpp>
#include <trophic/backend/mujoco/kernel/motion.hpp>
#include <trophic/backend/mujoco/kernel/proximity.hpp>
#include <trophic/backend/mujoco/kernel/search.hpp>

namespace trophic::backend::kernel {

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

/// Acceleration of the robots in `lanes` at the position and velocity in `state`, written to its acceleration, which is also the
/// warm start (mj_forward). Returns the lanes that the kernel could compute: no corner whose contact rounding decides, joint
/// angles it can take sines of, search settled, result below MuJoCo's bound for accelerations; all this for its whole company.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned forward(const KernelModel& model, LaneState& state, Workspace& work, unsigned lanes) {
  move_links(model, state, work);
  place_centres(model, work);
  work.doubtful = Mask{};
  unsigned coupled = find_link_contacts(model, state, work, lanes);
  coupled |= find_field_contacts(model, state, work, lanes);
  limit_joints(model, state, work);
  find_contacts(model, state, work);
  lanes = complete(work, lanes & ~lane_bits(work.doubtful));
  if (const unsigned apart = lanes & ~coupled; apart != 0) lanes &= ~minimise(model, state, work, apart);
  if (const unsigned together = lanes & coupled; together != 0) lanes &= ~minimise_coupled(model, state, work, together);
  work.rows_known = true;

  const LinkWork& root = work.links[0];
  Mask good = mask_of(lanes);
  for (int i = 0; i < 3; ++i) {
    good &= (abs(root.trial.linear[i]) < mjMAXVAL) & (abs(root.trial.angular[i]) < 0.5 * mjMAXVAL);
  }
  for (std::size_t j = 0; j < model.hinges.size(); ++j) {
    good &= (abs(work.hinges[j].trial) < mjMAXVAL) & (abs(state.position[7 + j]) < largest_angle_rad);
  }
  const unsigned computed = complete(work, lane_bits(good));
  take_trial(work, mask_of(computed), state.acceleration);
  return computed;
}

/// position += time velocity in the lanes of `moved`: the quaternion is turned by the angular velocity in the root's axes
/// (mj_integratePos).
TROPHIC_LANES_INLINE void move(const KernelModel& model, const Mask& moved, double time_s, const LaneArray& velocity,
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
TROPHIC_LANES_INLINE void finish_euler(const KernelModel& model, LaneState& state, Workspace& work, unsigned good) {
  const Mask moved = mask_of(good);
  const LaneArray* acceleration = &state.acceleration;
  if (model.damped) {
    damp_joints(model, work);
    take_trial(work, moved, work.sum.acceleration);
    acceleration = &work.sum.acceleration;
  }
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    state.velocity[i] = select(moved, state.velocity[i] + model.timestep_s * (*acceleration)[i], state.velocity[i]);
  }
  move(model, moved, model.timestep_s, state.velocity, state.position);
}

/// x += h sum of weighted velocities, v += h sum of weighted accelerations, warm start of the last stage.
TROPHIC_LANES_INLINE void finish_runge_kutta(const KernelModel& model, LaneState& state, const Workspace& work, unsigned good) {
  const Mask moved = mask_of(good);
  move(model, moved, model.timestep_s, work.sum.velocity, state.position);
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    state.velocity[i] = select(moved, state.velocity[i] + model.timestep_s * work.sum.acceleration[i], state.velocity[i]);
    state.acceleration[i] = select(moved, work.stage.acceleration[i], state.acceleration[i]);
  }
}

/// One step of the robots in `lanes`; returns the lanes that were stepped, the others keep their state.
///
/// The classical Runge-Kutta method of order 4 (mj_RungeKutta) evaluates the acceleration at x, x + h/2 v1, x + h/2 v2, x + h v3,
/// and sums with weights 1/6, 1/3, 1/3, 1/6. A lane that fails in any stage fails.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned any_step(const KernelModel& model, LaneState& state, Workspace& work,
                                                     unsigned lanes) {
  constexpr double ahead[3] = {0.5, 0.5, 1.0};
  constexpr double weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  const bool euler = !model.runge_kutta;
  const std::size_t speeds = state.velocity.size();
  LaneState& stage = euler ? state : work.stage;
  LaneState& sum = work.sum;
  if (!euler) {
    stage = state;
    normalize_quaternion(state.position);
    for (std::size_t i = 0; i < speeds; ++i) sum.velocity[i] = sum.acceleration[i] = Real{};
  }
  unsigned good = lanes;
  for (std::size_t s = 0; good != 0; ++s) {
    good = forward(model, stage, work, good);
    if (euler) {
      finish_euler(model, state, work, good);
      break;
    }
    for (std::size_t i = 0; i < speeds; ++i) {
      sum.velocity[i] += weight[s] * stage.velocity[i];
      sum.acceleration[i] += weight[s] * stage.acceleration[i];
    }
    if (s == 3) {
      finish_runge_kutta(model, state, work, good);
      break;
    }
    const double step_s = ahead[s] * model.timestep_s;
    stage.position = state.position;
    move(model, mask_of(good), step_s, stage.velocity, stage.position);
    for (std::size_t i = 0; i < speeds; ++i) stage.velocity[i] = state.velocity[i] + step_s * stage.acceleration[i];
  }
  return good;
}

}  // namespace trophic::backend::kernel
