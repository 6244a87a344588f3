// SPDX-License-Identifier: MIT
// Third stage of a step: the acceleration that minimises MuJoCo's constraint problem, exactly.
#pragma once

#include <trophic/backend/mujoco/kernel/contact.hpp>
#include <trophic/backend/mujoco/kernel/workspace.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

// MuJoCo minimises over accelerations x, with x_s the acceleration without constraints,
//   cost(x) = 1/2 (x - x_s)' M (x - x_s) + sum over rows of 1/2 D min(0, J x - aref)^2,
// which is strictly convex and piecewise quadratic. For a given set of active rows the minimum of the quadratic solves
//   (M + J' D J) x = M x_s + J' D aref.
// J' D J of the contacts of one link is a symmetric 6x6 matrix added to the link's spatial inertia, so the system is solved in
// O(links) by the articulated-body recursion (Featherstone, "Rigid Body Dynamics Algorithms", ch. 7) with those inertias. If
// the rows active at the solution are those of its computation, it is the minimum, to rounding; else the search continues.

/// Weights of a contact's active rows summed: [normal, coupling to t1, to t2, t1, t2] of the 3x3 matrix W = sum D e e',
/// e = n +- mu t.
struct RowSum {
  Real normal, first_coupling, second_coupling, first, second;
};

template <class Contact>
[[nodiscard]] TROPHIC_LANES_INLINE RowSum sum_rows(const Contact& contact, double mu, double sign) {
  const Real d0 = where(contact.active[0], contact.weight);
  const Real d1 = where(contact.active[1], contact.weight);
  const Real d2 = where(contact.active[2], contact.weight);
  const Real d3 = where(contact.active[3], contact.weight);
  const Real first = d0 + d1;
  const Real second = d2 + d3;
  return {first + second, (sign * mu) * (d0 - d1), (sign * mu) * (d2 - d3), (mu * mu) * first, (mu * mu) * second};
}

/// Adds the active rows of a contact to its link: inertia += X' W X and bias force += X' W offset, where X = [-[p]x, 1] maps the
/// link's motion to the contact point's.
template <int Axis>
TROPHIC_LANES_INLINE void add_contact(const ContactWork& contact, double mu, double sign, LinkWork& link) {
  const RowSum w = sum_rows(contact, mu, sign);
  const Vec3& o = contact.offset;
  // The point in the contact's cyclic coordinates, in which a cross product has its usual form.
  constexpr int n = Axis, s = (Axis + 1) % 3, t = (Axis + 2) % 3;
  const Real p0 = contact.point[n], p1 = contact.point[s], p2 = contact.point[t];

  const Real f0 = w.normal * o[0] + w.first_coupling * o[1] + w.second_coupling * o[2];
  const Real f1 = w.first_coupling * o[0] + w.first * o[1];
  const Real f2 = w.second_coupling * o[0] + w.second * o[2];
  Spatial& force = link.force;
  force.linear[n] += f0;
  force.linear[s] += f1;
  force.linear[t] += f2;
  force.angular[n] += p1 * f2 - p2 * f1;
  force.angular[s] += p2 * f0 - p0 * f2;
  force.angular[t] += p0 * f1 - p1 * f0;

  Inertia6& inertia = link.articulated;
  inertia.linear(n, n) += w.normal;
  inertia.linear(n, s) += w.first_coupling;
  inertia.linear(n, t) += w.second_coupling;
  inertia.linear(s, s) += w.first;
  inertia.linear(t, t) += w.second;
  // [p]x W
  const Real c00 = p1 * w.second_coupling - p2 * w.first_coupling, c01 = -(p2 * w.first), c02 = p1 * w.second;
  const Real c10 = p2 * w.normal - p0 * w.second_coupling, c11 = p2 * w.first_coupling,
             c12 = p2 * w.second_coupling - p0 * w.second;
  const Real c20 = p0 * w.first_coupling - p1 * w.normal, c21 = p0 * w.first - p1 * w.first_coupling,
             c22 = -(p1 * w.second_coupling);
  auto& coupling = inertia.coupling;
  coupling[n][n] += c00;
  coupling[n][s] += c01;
  coupling[n][t] += c02;
  coupling[s][n] += c10;
  coupling[s][s] += c11;
  coupling[s][t] += c12;
  coupling[t][n] += c20;
  coupling[t][s] += c21;
  coupling[t][t] += c22;
  // [p]x W [p]x'
  inertia.angular(n, n) += p1 * c02 - p2 * c01;
  inertia.angular(n, s) += p2 * c00 - p0 * c02;
  inertia.angular(n, t) += p0 * c01 - p1 * c00;
  inertia.angular(s, s) += p2 * c10 - p0 * c12;
  inertia.angular(s, t) += p0 * c11 - p1 * c10;
  inertia.angular(t, t) += p0 * c21 - p1 * c20;
}

/// parent += child without its hinge: articulated -= U U' / d, force += U u / d.
TROPHIC_LANES_INLINE void pass_inwards(const LinkWork& child, LinkWork& parent) {
  const Spatial& u = child.reach;
  const Spatial scaled = u * child.inverse;
  const Inertia6& from = child.articulated;
  Inertia6& to = parent.articulated;
  for (int i = 0; i < 3; ++i) {
    to.angular.v[i] += from.angular.v[i] - scaled.angular[i] * u.angular[i];
    to.linear.v[i] += from.linear.v[i] - scaled.linear[i] * u.linear[i];
    for (int j = 0; j < 3; ++j) to.coupling[i][j] += from.coupling[i][j] - scaled.angular[i] * u.linear[j];
  }
  constexpr int rows[3] = {0, 0, 1};
  constexpr int columns[3] = {1, 2, 2};
  for (int k = 0; k < 3; ++k) {
    to.angular.v[3 + k] += from.angular.v[3 + k] - scaled.angular[rows[k]] * u.angular[columns[k]];
    to.linear.v[3 + k] += from.linear.v[3 + k] - scaled.linear[rows[k]] * u.linear[columns[k]];
  }
  parent.force = parent.force + child.force + scaled * child.torque;
}

/// Solves for a hinge, given its parent's motion: its link and all links beyond it act on the parent as an inertia and a force.
TROPHIC_LANES_INLINE void eliminate_hinge(LinkWork& link, LinkWork& parent) {
  link.reach = link.articulated * link.axis;
  link.inverse = 1.0 / (dot(link.axis, link.reach) + link.load);
  link.torque -= dot(link.axis, link.force);
  pass_inwards(link, parent);
}

/// Acceleration of an eliminated hinge.
[[nodiscard]] TROPHIC_LANES_INLINE Real eliminated_acceleration(const LinkWork& link, const Spatial& parent) {
  return (link.torque - dot(link.reach, parent)) * link.inverse;
}

/// Motion x with inertia x = -force: the linear part is eliminated first, both halves by 3x3 inverses.
[[nodiscard]] TROPHIC_LANES_INLINE Spatial solve_root(const Inertia6& inertia, const Spatial& force) {
  const Sym3 linear = inverse(inertia.linear);
  const auto& c = inertia.coupling;
  Vec3 rows[3];  // C L^-1
  for (int i = 0; i < 3; ++i) rows[i] = linear * Vec3{{c[i][0], c[i][1], c[i][2]}};
  Sym3 schur = inertia.angular;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) schur(i, j) -= rows[i][0] * c[j][0] + rows[i][1] * c[j][1] + rows[i][2] * c[j][2];
  }
  Vec3 torque;
  for (int i = 0; i < 3; ++i) torque[i] = dot(rows[i], force.linear) - force.angular[i];
  Spatial x;
  x.angular = inverse(schur) * torque;
  Vec3 rest;
  for (int j = 0; j < 3; ++j) {
    rest[j] = -(force.linear[j] + c[0][j] * x.angular[0] + c[1][j] * x.angular[1] + c[2][j] * x.angular[2]);
  }
  x.linear = linear * rest;
  return x;
}

/// Any link.
struct EveryLink {
  TROPHIC_LANES_INLINE bool operator()(const LinkWork&) const { return true; }
};

/// Calls `visit.template visit<Axis>(contact, sign, link)` for each contact of the links for which `wanted` is true.
template <class Visitor, class Wanted = EveryLink>
TROPHIC_LANES_INLINE void for_each_contact(const LaneModel& model, Workspace& work, Visitor visit, Wanted wanted = {}) {
  for (std::size_t g = 0; g < work.group_count; ++g) {
    const ContactGroup& group = work.groups[g];
    const Plane& plane = model.shape().planes[group.plane];
    LinkWork& link = work.links[group.link];
    if (!wanted(link)) continue;
    ContactWork* const first = work.contacts.data() + group.first;
    ContactWork* const last = first + group.count;
    switch (plane.axis) {
      case 0:
        for (ContactWork* c = first; c != last; ++c) visit.template visit<0>(*c, plane.sign, link);
        break;
      case 1:
        for (ContactWork* c = first; c != last; ++c) visit.template visit<1>(*c, plane.sign, link);
        break;
      default:
        for (ContactWork* c = first; c != last; ++c) visit.template visit<2>(*c, plane.sign, link);
        break;
    }
  }
}

struct AddContact {
  double mu;
  template <int Axis>
  TROPHIC_LANES_INLINE void visit(const ContactWork& contact, double sign, LinkWork& link) const {
    add_contact<Axis>(contact, mu, sign, link);
  }
};

/// Solves for the root, then outwards for all hinges: sets `trial` of all links and hinges.
TROPHIC_LANES_INLINE void solve_outwards(const LaneModel& model, Workspace& work) {
  work.links[0].trial = solve_root(work.links[0].articulated, work.links[0].force);
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    LinkWork& link = work.links[i];
    const Spatial& parent = work.links[model.links[i].parent].trial;
    const Real acceleration = eliminated_acceleration(link, parent);
    work.hinges[i - 1].trial = acceleration;
    link.trial = parent + link.axis * acceleration;
  }
}

/// Solves for the joint and root accelerations x of `articulated`, `force` of all links and `load` (added to the diagonal),
/// `torque` of all hinges.
TROPHIC_LANES_INLINE void solve_tree(const LaneModel& model, Workspace& work) {
  for (std::size_t i = model.links.size() - 1; i > 0; --i) {
    eliminate_hinge(work.links[i], work.links[model.links[i].parent]);
  }
  solve_outwards(model, work);
}

/// Inertia and force of a link without contacts, torque of its hinge with the limit if that is active.
TROPHIC_LANES_INLINE void gather_link(Workspace& work, std::size_t i) {
  LinkWork& link = work.links[i];
  expand(link.inertia, link.articulated);
  link.force = link.bias;
  if (i == 0) return;
  const HingeWork& hinge = work.hinges[i - 1];
  link.load = where(hinge.limit_active, hinge.limit_weight);
  link.torque = hinge.torque + where(hinge.limit_active, hinge.limit_side * hinge.limit_weight * hinge.limit_offset);
}

/// Inertias, forces and torques of all links with the active rows.
TROPHIC_LANES_INLINE void gather_active(const LaneModel& model, Workspace& work) {
  for (std::size_t i = 0; i < model.links.size(); ++i) gather_link(work, i);
  for_each_contact(model, work, AddContact{model.shape().friction});
}

/// The minimum of the quadratic of the active rows. Unless `all`, the last solution differs only by rows that `evaluate_trial`
/// changed in `lanes`: links without such rows in them or further out are unchanged. One code for both, because the processor's
/// cache of instructions does not hold two.
TROPHIC_LANES_INLINE void solve_active(const LaneModel& model, Workspace& work, unsigned lanes, bool all) {
  for (LinkWork& link : work.links) link.is_stale = all || (lane_bits(link.changed) & lanes) != 0;
  for (std::size_t i = model.links.size() - 1; i > 0; --i) {
    if (work.links[i].is_stale) work.links[model.links[i].parent].is_stale = true;
  }
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (work.links[i].is_stale) gather_link(work, i);
  }
  for_each_contact(model, work, AddContact{model.shape().friction}, [](const LinkWork& link) { return link.is_stale; });
  for (std::size_t i = model.links.size() - 1; i > 0; --i) {
    LinkWork& link = work.links[i];
    LinkWork& parent = work.links[model.links[i].parent];
    if (link.is_stale) {
      eliminate_hinge(link, parent);
    } else if (parent.is_stale) {
      pass_inwards(link, parent);
    }
  }
  solve_outwards(model, work);
}

/// Replaces the trial acceleration a by that of Euler's method implicit in joint damping B: (M + h B) x = M a.
TROPHIC_LANES_INLINE void damp_joints(const LaneModel& model, Workspace& work) {
  for (LinkWork& link : work.links) {
    expand(link.inertia, link.articulated);
    link.force = (link.inertia * link.trial) * broadcast(-1.0);
  }
  for (std::size_t j = 0; j < model.hinges.size(); ++j) {
    work.links[j + 1].load = model.shape().timestep_s * model.hinges[j].damping;
    work.links[j + 1].torque = Real{};
  }
  solve_tree(model, work);
}

/// Finds the rows active at `residual`; returns the lanes in which they differ from `active`, which is updated.
TROPHIC_LANES_INLINE Mask update_rows(const Vec3& residual, double mu, double sign, Mask* active) {
  const Real normal = sign * residual[0];
  const Real first = mu * residual[1];
  const Real second = mu * residual[2];
  const Mask now[4] = {normal + first < 0.0, normal - first < 0.0, normal + second < 0.0, normal - second < 0.0};
  Mask changed{};
  for (int r = 0; r < 4; ++r) {
    changed |= active[r] ^ now[r];
    active[r] = now[r];
  }
  return changed;
}

/// Residuals at the trial point; the rows that are active there become the active ones.
struct TryContact {
  double mu;
  template <int Axis>
  TROPHIC_LANES_INLINE void visit(ContactWork& contact, double sign, LinkWork& link) const {
    const Vec3 motion = point_motion(link.trial, contact.point);
    for (int k = 0; k < 3; ++k) contact.trial[k] = motion[(Axis + k) % 3] + contact.offset[k];
    link.changed |= update_rows(contact.trial, mu, sign, contact.active);
  }
};

/// Evaluates all rows at the trial point; `changed` of a link becomes the lanes in which its rows differ from before. Returns
/// the lanes in which any do.
TROPHIC_LANES_INLINE Mask evaluate_trial(const LaneModel& model, Workspace& work) {
  work.links[0].changed = Mask{};
  for (std::size_t j = 0; j < work.hinges.size(); ++j) {
    HingeWork& hinge = work.hinges[j];
    const Mask now = hinge.limit_offset - hinge.limit_side * hinge.trial < 0.0;
    work.links[j + 1].changed = hinge.limit_active ^ now;
    hinge.limit_active = now;
  }
  for_each_contact(model, work, TryContact{model.shape().friction});
  Mask changed{};
  for (const LinkWork& link : work.links) changed |= link.changed;
  return changed;
}

/// Makes the trial point the current one.
struct AcceptContact {
  template <int>
  TROPHIC_LANES_INLINE void visit(ContactWork& contact, double, const LinkWork&) const {
    contact.residual = contact.trial;
  }
};

TROPHIC_LANES_INLINE void accept_trial(const LaneModel& model, Workspace& work) {
  for (LinkWork& link : work.links) link.acceleration = link.trial;
  for (HingeWork& hinge : work.hinges) hinge.acceleration = hinge.trial;
  for_each_contact(model, work, AcceptContact{});
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
