// SPDX-License-Identifier: MIT
// The kernel's model of a robot, its ground and its solver: constants that robots with the same body share.
#pragma once

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <trophic/backend/mujoco/box_depth.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// Softness of contacts and joint limits: MuJoCo's solimp (impedance as a function of depth, power 2), and the reference
/// acceleration that its solref stands for.
struct ContactLaw {
  double impedance_min;
  double impedance_max;
  double width_m;
  double midpoint;
  double damping_per_s;     ///< B in aref = -B v - K imp r
  double stiffness_per_s2;  ///< K in the same equation
  friend bool operator==(const ContactLaw&, const ContactLaw&) = default;
};

/// The half space sign * x[axis] < offset_m is solid; `axis` 0, 1, 2 is world x, y, z.
struct Plane {
  int axis;
  double sign;
  double offset_m;
};

/// The ground as a height field: a MuJoCo model of it and a box, whose test finds its contacts.
struct Field {
  std::shared_ptr<const mjModel> model;
  int geom;
  int box;  ///< any box
};

/// The constants of a body, as plain numbers. The kernel keeps the same structs with a number per lane (`lane_model.hpp`).
struct Plain {
  using Number = double;
  template <std::size_t Size>
  using Numbers = std::array<double, Size>;
};
template <class Kind>
using Number = typename Kind::Number;
template <class Kind, std::size_t Size>
using Numbers = typename Kind::template Numbers<Size>;

template <class Kind>
struct BoxNumbers {
  Numbers<Kind, 3> centre_m;
  Numbers<Kind, 3> half_extents_m;
  Numbers<Kind, 9> axes;  ///< column-major: directions of the box's axes in the link's frame
  Number<Kind> radius_m;  ///< radius of its bounding sphere
};
struct KernelBox : BoxNumbers<Plain> {
  bool aligned;  ///< axes are the link's own
  /// Half extents and axes as in MuJoCo's model, because the points that its tests report depend on their order.
  std::array<double, 3> geom_half_extents_m;
  std::array<double, 9> geom_axes;
};

template <class Kind>
struct LinkNumbers {
  Numbers<Kind, 3> offset_m;  ///< anchor in the parent's frame
  Numbers<Kind, 9> rotation;  ///< column-major: own axes at joint angle 0 in the parent's frame
  Number<Kind> mass_kg;
  Numbers<Kind, 3> centre_of_mass_m;
  Numbers<Kind, 6> inertia_kgm2;     ///< about the centre of mass: xx, yy, zz, xy, xz, yz
  Numbers<Kind, 3> sphere_centre_m;  ///< centre of a sphere that contains all boxes
  Number<Kind> sphere_radius_m;
  Number<Kind> reach_m;                ///< no box of the link or of a link further out is farther from its anchor
  Number<Kind> inverse_weight_per_kg;  ///< `own_inverse_weight_per_kg` and that of the ground
};
/// A link in the kernel's own frame: origin in the hinge's anchor, third axis along the hinge. The root keeps its frame.
struct KernelLink : LinkNumbers<Plain> {
  std::size_t parent;
  std::size_t first_box;
  std::size_t boxes;
  double own_inverse_weight_per_kg;  ///< body_invweight0: mean diagonal of J M^-1 J' at the centre of mass
};

/// Joint and servo: torque = gain * clipped target + bias + angle_gain * angle + rate_gain * rate.
template <class Kind>
struct HingeNumbers {
  Number<Kind> lower_rad;
  Number<Kind> upper_rad;
  Number<Kind> damping;         ///< N m s, of the joint itself
  Number<Kind> inverse_weight;  ///< dof_invweight0: diagonal entry of M^-1 at joint angles 0
  Number<Kind> gain;
  Number<Kind> bias;
  Number<Kind> angle_gain;
  Number<Kind> rate_gain;
  Number<Kind> lowest_target_rad;
  Number<Kind> highest_target_rad;
};
struct KernelHinge : HingeNumbers<Plain> {
  std::size_t servo;  ///< the hinge's number in the RobotModel, whose order MuJoCo's joints need not have
};

/// Two links that can collide: neither is the other's parent.
struct LinkPair {
  std::size_t first;
  std::size_t second;
};

/// The kernel's constants of one body in one arena. Link 0 is the root; link i > 0 is joined to its parent by hinge i - 1, which
/// is number 7 + i - 1 of qpos.
struct KernelModel {
  std::vector<KernelLink> links;
  std::vector<KernelHinge> hinges;
  std::vector<KernelBox> boxes;
  std::vector<LinkPair> pairs;
  std::vector<Plane> planes;
  std::optional<Field> field;
  double bounding_radius_m = 0.0;  ///< no box point is farther from the root's origin
  double friction = 0.0;           ///< friction between a link and the ground
  double link_friction = 0.0;      ///< friction between two links
  double timestep_s = 0.0;
  double gravity_m_s2 = 0.0;
  bool runge_kutta = false;
  mujoco::BoxDepth box_depth = mujoco::BoxDepth::engine;
  bool damped = false;  ///< any joint damping, which Euler's method takes implicitly
  ContactLaw law{};
};

/// Whether two bodies in the same arena may share a pack: they need the same tree, the same number of boxes on each link, and
/// equal softness and friction. Lengths, angles, masses and servos may differ.
[[nodiscard]] inline bool same_shape(const KernelModel& a, const KernelModel& b) {
  const auto same_link = [](const KernelLink& x, const KernelLink& y) { return x.parent == y.parent && x.boxes == y.boxes; };
  const auto same_box = [](const KernelBox& x, const KernelBox& y) { return x.aligned == y.aligned; };
  return a.friction == b.friction && a.link_friction == b.link_friction && a.damped == b.damped && a.law == b.law &&
         std::ranges::equal(a.links, b.links, same_link) && std::ranges::equal(a.boxes, b.boxes, same_box);
}

}  // namespace trophic::backend::kernel
