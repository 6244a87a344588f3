// SPDX-License-Identifier: MIT
// First stage of a step: positions, velocities and inertias of the links, and the forces without constraints.
#pragma once

#include <trophic/backend/mujoco/kernel/workspace.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// Scales the quaternion in a position to length 1.
TROPHIC_LANES_INLINE void normalize_quaternion(LaneArray& position) {
  Real square{};
  for (std::size_t i = 3; i < 7; ++i) square += position[i] * position[i];
  const Real scale = 1.0 / sqrt(square);
  for (std::size_t i = 3; i < 7; ++i) position[i] *= scale;
}

[[nodiscard]] TROPHIC_LANES_INLINE Mat3 root_rotation(const LaneArray& position) {
  const Real q[4] = {position[3], position[4], position[5], position[6]};
  const Real ww = q[0] * q[0], xx = q[1] * q[1], yy = q[2] * q[2], zz = q[3] * q[3];
  const Real xy = q[1] * q[2], xz = q[1] * q[3], yz = q[2] * q[3], wx = q[0] * q[1], wy = q[0] * q[2], wz = q[0] * q[3];
  return {{{{ww + xx - yy - zz, 2.0 * (xy + wz), 2.0 * (xz - wy)}},
           {{2.0 * (xy - wz), ww - xx + yy - zz, 2.0 * (yz + wx)}},
           {{2.0 * (xz + wy), 2.0 * (yz - wx), ww - xx - yy + zz}}}};
}

/// Sphere and inertia about the root's origin in world axes: R I R' and the parallel axis theorem, I + m (c'c 1 - c c').
TROPHIC_LANES_INLINE void place_inertia(const LaneLink& link, LinkWork& work) {
  work.sphere_centre = work.anchor + rotate(work.rotation, link.sphere_centre_m);
  const Vec3 centre = work.anchor + rotate(work.rotation, link.centre_of_mass_m);
  const Real* const own = link.inertia_kgm2;
  const Real rows[3][3] = {{own[0], own[3], own[4]}, {own[3], own[1], own[5]}, {own[4], own[5], own[2]}};
  const Real mass = link.mass_kg;
  RigidInertia& inertia = work.inertia;
  inertia.mass_kg = mass;
  for (int i = 0; i < 3; ++i) inertia.moment[i] = mass * centre[i];
  const Vec3& h = inertia.moment;
  Sym3& sum = inertia.rotational;
  sum.v[0] = h[1] * centre[1] + h[2] * centre[2];
  sum.v[1] = h[0] * centre[0] + h[2] * centre[2];
  sum.v[2] = h[0] * centre[0] + h[1] * centre[1];
  sum.v[3] = -(h[0] * centre[1]);
  sum.v[4] = -(h[0] * centre[2]);
  sum.v[5] = -(h[1] * centre[2]);
  for (int k = 0; k < 3; ++k) {
    const Vec3 turned = rotate(work.rotation, rows[k]);
    const Vec3& column = work.rotation.column[k];
    for (int i = 0; i < 3; ++i) sum.v[i] += turned[i] * column[i];
    sum.v[3] += turned[0] * column[1];
    sum.v[4] += turned[0] * column[2];
    sum.v[5] += turned[1] * column[2];
  }
}

/// p = I drift + V x* I V.
TROPHIC_LANES_INLINE void set_bias(LinkWork& work) {
  work.bias = work.inertia * work.drift + cross_force(work.velocity, work.inertia * work.velocity);
}

/// Kinematics, inertias and bias forces of all links, torques of all servos, in one pass from the root outwards.
///
/// R_i = R_p F_i Rz(q_i); S_i = (a_i, r_i x a_i) with hinge axis a_i through r_i; V_i = V_p + S_i q'_i;
/// drift_i = drift_p + V_p x S_i q'_i, drift_0 = (0, -w x v - g). The joint torque is the servo's and the joint's own damping.
/// The quaternion in `state` is normalised.
TROPHIC_LANES_INLINE void move_links(const LaneModel& model, LaneState& state, Workspace& work) {
  const LaneArray& position = state.position;
  const LaneArray& velocity = state.velocity;
  normalize_quaternion(state.position);
  LinkWork& root = work.links[0];
  root.rotation = root_rotation(position);
  root.anchor = {};
  const Vec3 linear = {{velocity[0], velocity[1], velocity[2]}};
  const Vec3 angular = root.rotation * Vec3{{velocity[3], velocity[4], velocity[5]}};
  root.velocity = {angular, linear};
  root.drift.angular = {};
  root.drift.linear = cross(linear, angular);
  root.drift.linear[2] += model.shape().gravity_m_s2;
  place_inertia(model.links[0], root);
  set_bias(root);

  for (std::size_t i = 1; i < model.links.size(); ++i) {
    const LaneLink& link = model.links[i];
    const LaneHinge& hinge = model.hinges[i - 1];
    LinkWork& own = work.links[i];
    const LinkWork& parent = work.links[link.parent];
    const Real angle = position[7 + i - 1];
    const Real rate = velocity[6 + i - 1];
    own.anchor = parent.anchor + rotate(parent.rotation, link.offset_m);
    Real sine, cosine;
    sine_cosine(angle, sine, cosine);
    const Vec3 first = rotate(parent.rotation, link.rotation);
    const Vec3 second = rotate(parent.rotation, link.rotation + 3);
    own.rotation.column[0] = first * cosine + second * sine;
    own.rotation.column[1] = second * cosine - first * sine;
    own.rotation.column[2] = rotate(parent.rotation, link.rotation + 6);
    own.axis.angular = own.rotation.column[2];
    own.axis.linear = cross(own.anchor, own.axis.angular);
    const Spatial swing = own.axis * rate;
    own.velocity = parent.velocity + swing;
    own.drift = parent.drift + cross_motion(parent.velocity, swing);
    place_inertia(link, own);
    set_bias(own);
    const Real& lowest = hinge.lowest_target_rad;
    const Real& highest = hinge.highest_target_rad;
    const Real target = state.target[i - 1];
    const Real clipped = select(target > highest, highest, select(target < lowest, lowest, target));
    work.hinges[i - 1].torque = hinge.gain * clipped + hinge.bias + hinge.angle_gain * angle + hinge.rate_gain * rate;
  }
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
