// SPDX-License-Identifier: MIT
// One step of a crew of robots, as MuJoCo 2.2.2's mj_step computes it.
#pragma once

#include <trophic/backend/mujoco/kernel/knots.hpp>
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

/// Acceleration of the robots that are `going` at the position and velocity of this stage, written to its acceleration, which is
/// also the warm start (mj_forward). Robots that the kernel cannot compute stop `going`: a corner or link whose contact
/// rounding decides, joint angles it cannot take sines of, a search that does not settle, a result above MuJoCo's bound for
/// accelerations, and robots tied to such a robot.
TROPHIC_LANES_INLINE void forward(Crew& crew) {
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    Team& team = *crew.teams[t];
    move_links(team.model, team.current(), team.work);
    place_centres(team.model, team.work);
    team.work.doubtful = Mask{};
  }
  find_link_contacts(crew);
  unsigned coupled = 0;
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    Team& team = *crew.teams[t];
    find_field_contacts(team, crew.field_collider);
    limit_joints(team.model, team.current(), team.work);
    find_contacts(team.model, team.current(), team.work);
    team.going &= ~lane_bits(team.work.doubtful);
  }
  share_fate(crew);
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    Team& team = *crew.teams[t];
    coupled |= team.going & team.coupled;
    if (const unsigned apart = team.going & ~team.coupled; apart != 0) {
      team.going &= ~minimise(team.model, team.current(), team.work, apart);
    }
  }
  if (coupled != 0) minimise_knots(crew);
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    Team& team = *crew.teams[t];
    team.work.rows_known = true;
    const LinkWork& root = team.work.links[0];
    Mask good = mask_of(team.going);
    for (int i = 0; i < 3; ++i) {
      good &= (abs(root.trial.linear[i]) < mjMAXVAL) & (abs(root.trial.angular[i]) < 0.5 * mjMAXVAL);
    }
    for (std::size_t j = 0; j < team.work.hinges.size(); ++j) {
      good &= (abs(team.work.hinges[j].trial) < mjMAXVAL) & (abs(team.current().position[7 + j]) < largest_angle_rad);
    }
    team.going = lane_bits(good);
  }
  share_fate(crew);
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    Team& team = *crew.teams[t];
    take_trial(team.work, mask_of(team.going), team.current().acceleration);
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
TROPHIC_LANES_INLINE void begin_runge_kutta(Team& team) {
  LaneState& sum = team.work.sum;
  team.work.stage = team.state;
  normalize_quaternion(team.state.position);
  for (std::size_t i = 0; i < sum.velocity.size(); ++i) sum.velocity[i] = sum.acceleration[i] = Real{};
}

/// Adds stage `s` to the sums and goes to the next stage.
TROPHIC_LANES_INLINE void next_stage(Team& team, std::size_t s) {
  constexpr double ahead[4] = {0.5, 0.5, 1.0, 0.0};
  constexpr double weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  const LaneState& state = team.state;
  LaneState& stage = team.work.stage;
  LaneState& sum = team.work.sum;
  const std::size_t speeds = state.velocity.size();
  for (std::size_t i = 0; i < speeds; ++i) {
    sum.velocity[i] += weight[s] * stage.velocity[i];
    sum.acceleration[i] += weight[s] * stage.acceleration[i];
  }
  if (s == 3) return;
  const double step_s = ahead[s] * team.model.shape().timestep_s;
  stage.position = state.position;
  move(team.model, mask_of(team.going), step_s, stage.velocity, stage.position);
  for (std::size_t i = 0; i < speeds; ++i) stage.velocity[i] = state.velocity[i] + step_s * stage.acceleration[i];
}

/// One step of all robots of a crew. Afterwards those that took it are `going`; the others keep their state.
TROPHIC_LANES_INLINE void any_step(Crew& crew) {
  const bool euler = !crew.teams[0]->model.shape().runge_kutta;
  crew.ties.reset(crew.team_count * lane_count);
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    crew.teams[t]->going = crew.teams[t]->lanes;
    if (!euler) begin_runge_kutta(*crew.teams[t]);
  }
  // A robot that fails in one stage is not there in the next, so that its neighbours must fail too.
  if (!euler) {
    for (const auto& [a, b] : crew.neighbours) crew.ties.join(a, b);
  }
  const std::size_t stages = euler ? 1 : 4;
  for (std::size_t s = 0; s < stages; ++s) {
    crew.knot_ties.reset(crew.team_count * lane_count);
    forward(crew);
    for (std::size_t t = 0; !euler && t < crew.team_count; ++t) next_stage(*crew.teams[t], s);
  }
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    Team& team = *crew.teams[t];
    if (euler) {
      finish_euler(team.model, team.state, team.work, team.going);
    } else {
      finish_runge_kutta(team.model, team.state, team.work, team.going);
    }
  }
}

}  // namespace trophic::backend::kernel
