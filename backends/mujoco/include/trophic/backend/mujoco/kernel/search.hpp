// SPDX-License-Identifier: MIT
// The search over sets of active rows: full Newton steps, then Newton steps with exact line search.
#pragma once

#include <trophic/backend/mujoco/kernel/solver.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// Full steps tried before the line search, which makes the search finite, and the bound of all steps.
inline constexpr int full_steps = 6;
inline constexpr int largest_steps = 60;
/// The largest number of slope evaluations in one line search; if they do not suffice, the best bracket is used, which still
/// descends.
inline constexpr int line_steps = 30;

/// Slope of one row along the line, d/da of 1/2 D min(0, r0 + a (r1 - r0))^2, and its curvature.
TROPHIC_LANES_INLINE void add_row(const Real& start, const Real& end, const Real& weight, const Real& along, Real& slope,
                                  Real& curvature) {
  const Real step = end - start;
  const Real value = start + along * step;
  const Real active_step = where(value < 0.0, weight * step);
  slope += active_step * value;
  curvature += active_step * step;
}

/// Slope of all rows of the contacts at `along`.
struct SlopeContact {
  double mu;
  const Real* along;
  Real* slope;
  Real* curvature;
  template <int>
  TROPHIC_LANES_INLINE void visit(const ContactWork& contact, double sign, const LinkWork&) const {
    const Vec3& r = contact.residual;
    const Vec3& t = contact.trial;
    for (int k = 1; k < 3; ++k) {
      add_row(sign * r[0] + mu * r[k], sign * t[0] + mu * t[k], contact.weight, *along, *slope, *curvature);
      add_row(sign * r[0] - mu * r[k], sign * t[0] - mu * t[k], contact.weight, *along, *slope, *curvature);
    }
  }
};

TROPHIC_LANES_INLINE void row_slope(const LaneModel& model, Workspace& work, const Real& along, Real& slope, Real& curvature) {
  for_each_contact(model, work, SlopeContact{model.shape().friction, &along, &slope, &curvature});
  for (const HingeWork& hinge : work.hinges) {
    add_row(hinge.limit_offset - hinge.limit_side * hinge.acceleration, hinge.limit_offset - hinge.limit_side * hinge.trial,
            hinge.limit_weight, along, slope, curvature);
  }
}

/// Moves the trial point to `along` between current point (0) and trial point (1) in the lanes of `moved`.
struct MoveContact {
  double mu;
  const Mask* moved;
  const Real* along;
  template <int>
  TROPHIC_LANES_INLINE void visit(ContactWork& contact, double sign, const LinkWork&) const {
    contact.trial = select(*moved, contact.residual + (contact.trial - contact.residual) * *along, contact.trial);
    update_rows(contact.trial, mu, sign, contact.active);
  }
};

/// Exact line search from the current to the trial point in the lanes of `changed`, which becomes the trial point.
///
/// With v = trial - current the slope of the cost is, because the trial point is the minimum of the quadratic of the current
/// point's rows, slope(a) = (a - 1) v'Mv + rows(a) - rows active at 0, taken at 1; it increases, is piecewise linear and not
/// positive at 0. Newton's method on it, kept inside a bracket, ends at the root of the piece that holds it.
TROPHIC_LANES_INLINE void search_line(const LaneModel& model, Workspace& work, const Mask& changed) {
  Real quadratic{};
  for (const LinkWork& link : work.links) {
    const Spatial step = link.trial - link.acceleration;
    quadratic += dot(step, link.inertia * step);
  }
  Real start_slope{}, start_curvature{};
  row_slope(model, work, Real{}, start_slope, start_curvature);
  // Rows active at 0, as a quadratic, have the slope start_slope + start_curvature at 1.
  const Real constant = start_slope + start_curvature;
  Real low{};
  Real high = broadcast(1.0);
  Real along = high;
  Mask open = changed;
  for (int i = 0; i < line_steps && lane_bits(open) != 0; ++i) {
    Real slope = (along - 1.0) * quadratic - constant;
    Real curvature = quadratic;
    row_slope(model, work, along, slope, curvature);
    // Up to here the slope at 1 may be negative: the minimum then lies beyond, and the bracket grows.
    const Mask negative = slope < 0.0;
    low = select(open & negative, along, low);
    high = select(open & negative & (high <= along), along * 2.0, select(open & ~negative, along, high));
    const Real newton = along - slope / curvature;
    const Real next = select((newton > low) & (newton < high), newton, 0.5 * (low + high));
    open &= (next != along) & (abs(slope) > 1e-14 * (quadratic + abs(constant)));
    along = select(open, next, along);
  }
  for (LinkWork& link : work.links) {
    link.trial.angular =
        select(changed, link.acceleration.angular + (link.trial.angular - link.acceleration.angular) * along, link.trial.angular);
    link.trial.linear =
        select(changed, link.acceleration.linear + (link.trial.linear - link.acceleration.linear) * along, link.trial.linear);
  }
  for (HingeWork& hinge : work.hinges) {
    hinge.trial = select(changed, hinge.acceleration + (hinge.trial - hinge.acceleration) * along, hinge.trial);
    hinge.limit_active = hinge.limit_offset - hinge.limit_side * hinge.trial < 0.0;
  }
  for_each_contact(model, work, MoveContact{model.shape().friction, &changed, &along});
}

/// The rows that were active last: for each corner those of its last contact with the plane, or all if it had none, and all
/// exceeded joint limits.
TROPHIC_LANES_INLINE void recall_rows(Workspace& work) {
  for (std::size_t c = 0; c < work.contact_count; ++c) {
    ContactWork& contact = work.contacts[c];
    const Mask present = contact.depth < 0.0;
    Mask rows{};
    for (std::size_t lane = 0; lane < lane_count; ++lane) rows[lane] = work.active_rows[contact.memory[lane]];
    Mask bit = Mask{} + 1;
    for (Mask& active : contact.active) {
      active = ((rows & bit) != 0) & present;
      bit += bit;
    }
  }
  for (HingeWork& hinge : work.hinges) hinge.limit_active = hinge.limit_weight > 0.0;
}

/// Makes the last acceleration the trial point.
TROPHIC_LANES_INLINE void try_last(const LaneModel& model, const LaneState& state, Workspace& work) {
  const LaneArray& warm = state.acceleration;
  LinkWork& root = work.links[0];
  root.trial = {root.rotation * Vec3{{warm[3], warm[4], warm[5]}}, {{warm[0], warm[1], warm[2]}}};
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    work.hinges[i - 1].trial = warm[5 + i];
    work.links[i].trial = work.links[model.links[i].parent].trial + work.links[i].axis * warm[5 + i];
  }
}

/// The first guess of the active rows: those active last, which is more often right than MuJoCo's guess (those at the last
/// acceleration), or the latter if nothing is known of the last step. It affects only the number of steps, because the minimum is
/// unique and is computed from the rows active there.
TROPHIC_LANES_INLINE void first_rows(const LaneModel& model, const LaneState& state, Workspace& work) {
  recall_rows(work);
  if (work.rows_known) return;
  try_last(model, state, work);
  evaluate_trial(model, work);
}

/// Stores which rows are active in `lanes`.
TROPHIC_LANES_INLINE void remember_rows(Workspace& work, unsigned lanes) {
  for (std::size_t c = 0; c < work.contact_count; ++c) {
    const ContactWork& contact = work.contacts[c];
    const unsigned present = lane_bits(contact.depth < 0.0) & lanes;
    Mask rows{};
    Mask bit = Mask{} + 1;
    for (const Mask& active : contact.active) {
      rows |= active & bit;
      bit += bit;
    }
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if ((present & (1u << lane)) != 0) work.active_rows[contact.memory[lane]] = static_cast<std::uint8_t>(rows[lane]);
    }
  }
}

/// The acceleration that minimises the cost, as `trial` of links and hinges. A lane whose rows stay the same keeps its
/// solution bitwise, independent of the others. Returns those of `lanes` that did not settle.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned minimise(const LaneModel& model, const LaneState& state, Workspace& work,
                                                     unsigned lanes) {
  first_rows(model, state, work);
  Mask changed{};
  for (int step = 0; step < largest_steps; ++step) {
    if (step >= full_steps) accept_trial(model, work);
    solve_active(model, work, lanes, step == 0 || step >= full_steps);
    changed = evaluate_trial(model, work);
    if ((lane_bits(changed) & lanes) == 0) break;
    if (step >= full_steps) search_line(model, work, changed);
  }
  remember_rows(work, lanes);
  return lane_bits(changed) & lanes;
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
