// SPDX-License-Identifier: MIT
// Second stage of a step: contacts of boxes with planes, joint limits, and the constraint rows that they make.
#pragma once

#include <bit>
#include <cstdint>
#include <trophic/backend/mujoco/kernel/workspace.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// A row residual that no acceleration makes negative, so that the row of a lane without contact is never active.
inline constexpr double out_of_reach = 1e30;

/// For corners nearer to a plane than this, in metres, rounding alone decides about contact, for example if a robot is placed
/// flat; MuJoCo's rounding must decide.
inline constexpr double doubtful_m = 1e-12;

/// A sphere farther than this, in metres, from a plane has no corner in or near the plane; the value is far above rounding
/// errors.
inline constexpr double sphere_gap_m = 1e-9;

/// Impedance of a row at signed distance r (MuJoCo's solimp): x = |r| / width; y = x^2 / mid up to the midpoint, then
/// 1 - (1 - x)^2 / (1 - mid), 1 from x = 1; imp = dmin + y (dmax - dmin).
[[nodiscard]] TROPHIC_LANES_INLINE Real impedance(const ContactLaw& law, const Real& distance_m) {
  const Real x = abs(distance_m) * (1.0 / law.width_m);
  const Real rest = 1.0 - x;
  const Real low = x * x * (1.0 / law.midpoint);
  const Real high = 1.0 - rest * rest * (1.0 / (1.0 - law.midpoint));
  const Real y = select(x >= 1.0, broadcast(1.0), select(x <= law.midpoint, low, high));
  return law.impedance_min + y * (law.impedance_max - law.impedance_min);
}

/// Rows of joint limits. A hinge at distance r < 0 beyond its nearer limit has one row -side q'' with
/// aref = -B v - K imp r and D = imp / ((1 - imp) * dof_invweight0).
TROPHIC_LANES_INLINE void limit_joints(const LaneModel& model, const LaneState& state, Workspace& work) {
  for (std::size_t j = 0; j < model.hinges.size(); ++j) {
    const LaneHinge& hinge = model.hinges[j];
    HingeWork& own = work.hinges[j];
    const Real angle = state.position[7 + j];
    const Real below = angle - hinge.lower_rad;
    const Real above = hinge.upper_rad - angle;
    const Mask upper = above < below;
    const Real distance = select(upper, above, below);
    const Mask beyond = distance < 0.0;
    own.limit_side = select(upper, broadcast(1.0), broadcast(-1.0));
    const Real imp = impedance(model.shape().law, distance);
    own.limit_weight = where(beyond, imp / ((1.0 - imp) * hinge.inverse_weight));
    own.limit_offset = select(beyond,
                              model.shape().law.stiffness_per_s2 * imp * distance -
                                  model.shape().law.damping_per_s * own.limit_side * state.velocity[6 + j],
                              broadcast(out_of_reach));
  }
}

/// On which side of a box a corner lies along an axis: -1.0 or 1.0, from the corner's bits.
[[nodiscard]] constexpr double sign_of(unsigned corner, unsigned axis) {
  return (corner >> axis & 1u) != 0 ? 1.0 : -1.0;
}

/// A bit for each corner and lane.
using Corners = std::conditional_t<lane_count == four, std::uint32_t, std::uint64_t>;

/// Finds the contacts of one link with plane `index`, MuJoCo's plane-box rule: of the corners that are not above the box's centre
/// those below the plane, four at most in the order of the corners' sign bits; the contact point lies half the depth above the
/// corner. Returns their largest number in any lane.
template <int Axis>
TROPHIC_LANES_INLINE std::size_t collide(const LaneModel& model, const LaneLink& link, const LinkWork& pose, std::size_t index,
                                         const Real& origin_m, ContactWork* slots, Workspace& work) {
  const Plane& plane = model.shape().planes[index];
  std::size_t counts[lane_count] = {};
  std::size_t opened = 0;
  const Real base_m = origin_m + plane.sign * pose.anchor[Axis];
  // Height per unit along each axis of the link.
  const Real slope[3] = {plane.sign * pose.rotation.column[0][Axis], plane.sign * pose.rotation.column[1][Axis],
                         plane.sign * pose.rotation.column[2][Axis]};
  for (std::size_t b = link.first_box; b < link.first_box + link.boxes; ++b) {
    const LaneBox& box = model.boxes[b];
    const auto& c = box.centre_m;
    const Real centre_m = base_m + (slope[0] * c[0] + slope[1] * c[1] + slope[2] * c[2]);
    Real rise[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Real* axis = box.axes + 3 * k;
      const Real along = box.aligned ? slope[k] : slope[0] * axis[0] + slope[1] * axis[1] + slope[2] * axis[2];
      rise[k] = along * box.half_extents_m[k];
    }
    const Real reach_m = abs(rise[0]) + abs(rise[1]) + abs(rise[2]);
    if (lane_bits(centre_m < reach_m + doubtful_m) == 0) continue;

    const Vec3 centre = box_centre(pose, box);
    Vec3 half[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Real* axis = box.axes + 3 * k;
      half[k] = (box.aligned ? pose.rotation.column[k] : rotate(pose.rotation, axis)) * box.half_extents_m[k];
    }
    Corners hits = 0;  // bit corner * lane_count + lane: this corner is in contact in this lane
    Real distances_m[8];
    Mask doubtful{};
#pragma GCC unroll 8
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Real below_m = sign_of(corner, 0) * rise[0] + sign_of(corner, 1) * rise[1] + sign_of(corner, 2) * rise[2];
      distances_m[corner] = centre_m + below_m;
      doubtful |= abs(distances_m[corner]) < doubtful_m;
      hits |= Corners{lane_bits((below_m <= 0.0) & (distances_m[corner] < 0.0))} << (corner * lane_count);
    }
    work.doubtful |= doubtful;
    std::size_t found[lane_count] = {};
    while (hits != 0) {
      const unsigned corner = static_cast<unsigned>(std::countr_zero(hits)) / lane_count;
      const Real& distance_m = distances_m[corner];
      Vec3 point;
      for (int i = 0; i < 3; ++i) {
        point[i] =
            centre[i] + (sign_of(corner, 0) * half[0][i] + sign_of(corner, 1) * half[1][i] + sign_of(corner, 2) * half[2][i]);
      }
      point[Axis] -= (0.5 * plane.sign) * distance_m;
      for (; hits != 0 && static_cast<unsigned>(std::countr_zero(hits)) / lane_count == corner; hits &= hits - 1) {
        const std::size_t lane = static_cast<unsigned>(std::countr_zero(hits)) % lane_count;
        if (found[lane] == 4) continue;
        ++found[lane];
        const std::size_t slot = counts[lane]++;
        if (slot == opened) {
          slots[opened].point = {};
          slots[opened].depth = Real{};
          ++opened;
        }
        for (int i = 0; i < 3; ++i) slots[slot].point[i][lane] = point[i][lane];
        slots[slot].depth[lane] = distance_m[lane];
        slots[slot].memory[lane] = ((index * model.boxes.size() + b) * 8 + corner) * lane_count + lane;
      }
    }
  }
  return opened;
}

/// Rows of a pyramidal contact: n +- mu t1, n +- mu t2, each with aref = -B v - K imp r and, MuJoCo's pyramid,
/// D = 1 / (2 mu^2 R), R = (1 - imp) / imp (1 + mu^2) body_invweight0. With y = J q'' + B v + K imp r n (a vector), the rows'
/// residuals J q'' - aref are y_n +- mu y_t.
template <int Axis>
TROPHIC_LANES_INLINE void make_rows(const LaneModel& model, const LaneLink& link, const LinkWork& pose, const Plane& plane,
                                    ContactWork& contact) {
  const double mu = model.shape().friction;
  const Real imp = impedance(model.shape().law, contact.depth);
  const Mask present = contact.depth < 0.0;
  const Real scale = 2.0 * mu * mu * (1.0 + mu * mu) * link.inverse_weight_per_kg;
  contact.weight = where(present, imp / ((1.0 - imp) * scale));
  const Vec3 velocity = point_motion(pose.velocity, contact.point);
  for (int k = 0; k < 3; ++k) contact.offset[k] = where(present, model.shape().law.damping_per_s * velocity[(Axis + k) % 3]);
  const Real normal = contact.offset[0] + (plane.sign * model.shape().law.stiffness_per_s2) * imp * contact.depth;
  contact.offset[0] = select(present, normal, broadcast(plane.sign * out_of_reach));
}

/// Contacts of all links with plane `index`, appended to the workspace.
template <int Axis>
TROPHIC_LANES_INLINE void collide_all(const LaneModel& model, std::size_t index, const LaneState& state, Workspace& work) {
  const Plane& plane = model.shape().planes[index];
  const Real origin_m = plane.sign * state.position[Axis] - plane.offset_m;
  if (lane_bits(origin_m < model.bounding_radius_m) == 0) return;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Real height_m = origin_m + plane.sign * work.links[i].sphere_centre[Axis];
    if (lane_bits(height_m < model.links[i].sphere_radius_m + sphere_gap_m) == 0) continue;
    const std::size_t first = work.contact_count;
    const std::size_t count =
        collide<Axis>(model, model.links[i], work.links[i], index, origin_m, work.contacts.data() + first, work);
    if (count == 0) continue;
    for (std::size_t c = first; c < first + count; ++c) {
      make_rows<Axis>(model, model.links[i], work.links[i], plane, work.contacts[c]);
    }
    work.groups[work.group_count++] = {index, i, first, count};
    work.contact_count += count;
  }
}

/// All contacts of all links, grouped by plane and link, and the lanes that are left to MuJoCo.
TROPHIC_LANES_INLINE void find_contacts(const LaneModel& model, const LaneState& state, Workspace& work) {
  work.group_count = work.contact_count = 0;
  for (std::size_t index = 0; index < model.shape().planes.size(); ++index) {
    switch (model.shape().planes[index].axis) {
      case 0:
        collide_all<0>(model, index, state, work);
        break;
      case 1:
        collide_all<1>(model, index, state, work);
        break;
      default:
        collide_all<2>(model, index, state, work);
        break;
    }
  }
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
